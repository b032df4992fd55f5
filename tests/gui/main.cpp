#include <gtest/gtest.h>

#include <QApplication>

#include "tests/gui/virtual_screen.h"

// Tests of the window have a screen and a home of their own.
int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  if (GTEST_FLAG_GET(list_tests)) return RUN_ALL_TESTS();
  useEmptyHome();
  if (!startVirtualScreen()) return 1;
  QApplication::setApplicationName("Stipple");
  QApplication::setOrganizationName("Stipple");
  QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
  QApplication application(argc, argv);
  return RUN_ALL_TESTS();
}
