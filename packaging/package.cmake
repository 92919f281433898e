# SPDX-License-Identifier: LGPL-2.1-or-later
# The Debian package that tools/package makes. The workbench stands in /usr/lib/curveups, since its
# native module is of one architecture, and FreeCAD finds it by a link in its folder for all users.
set(place lib/curveups)
install(TARGETS _native LIBRARY DESTINATION ${place}/Workbench/curveups)
install(DIRECTORY Workbench DESTINATION ${place}
        FILES_MATCHING PATTERN "*.py" PATTERN "*.js" PATTERN "*.html" PATTERN "parameters.json" PATTERN "__pycache__" EXCLUDE)
install(DIRECTORY resources DESTINATION ${place})
install(FILES Init.py InitGui.py package.xml README.md LICENSE LICENSE.GPL-3.0
        DESTINATION ${place})
file(CREATE_LINK ../../../${place} ${PROJECT_BINARY_DIR}/CurveUps SYMBOLIC)
install(FILES ${PROJECT_BINARY_DIR}/CurveUps DESTINATION share/freecad/Mod)
install(PROGRAMS packaging/debian/curveups DESTINATION bin)
install(FILES CHANGELOG.md packaging/debian/copyright DESTINATION share/doc/curveups)
install(DIRECTORY build/libraries/licences DESTINATION share/doc/curveups)  # of what is linked in

# The Debian that this builds on is the one it is for: libraries' names and Python's version are its.
find_package(Python3 REQUIRED COMPONENTS Interpreter)
file(STRINGS /etc/os-release release REGEX "^VERSION_ID=")
string(REGEX REPLACE "[^0-9]" "" release "${release}")
math(EXPR next_python "${Python3_VERSION_MINOR} + 1")

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME curveups)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "curvy shells that are printed flat, as a FreeCAD workbench")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
    "A target surface becomes a flat layout of rigid tiles, which two pre-stretched membranes pull
 into shape. The package has the FreeCAD workbench and the command curveups.")
set(CPACK_PACKAGE_CONTACT "The CurveUps for FreeCAD authors <maintainers@curveups.invalid>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE "1~deb${release}")
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
string(CONCAT CPACK_DEBIAN_PACKAGE_DEPENDS
       "freecad (>= 0.20.2), python3-pivy, python3-numpy, python3-matplotlib, python3-scipy, "
       "python3-ezdxf, python3-jinja2, "
       "python3 (>= 3.${Python3_VERSION_MINOR}~), python3 (<< 3.${next_python})")
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA "${PROJECT_SOURCE_DIR}/packaging/debian/postinst"
                                       "${PROJECT_SOURCE_DIR}/packaging/debian/prerm")
include(CPack)
