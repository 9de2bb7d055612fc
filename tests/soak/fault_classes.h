// SPDX-License-Identifier: Apache-2.0
// The fault classes and the rules that the soak test gives to the controller.
#pragma once

#include <array>
#include <string_view>

namespace campanel::soak {

struct FaultClass {
    std::string_view name;
    std::string_view rules;
    // True when registers may differ from the written values: another device answers.
    bool otherIdentity = false;
};

inline constexpr std::array faultClasses{
    FaultClass{"none", "clear"},
    FaultClass{"late by 1 time-out", "late times=1 probability=0.08"},
    FaultClass{"late by 1.5", "late times=1.5 probability=0.08"},
    FaultClass{"late by 2.5", "late times=2.5 probability=0.08"},
    FaultClass{"late by 10", "late times=10 probability=0.08"},
    FaultClass{"late by 0.5 to 1.2", "late times=0.5 probability=0.04; late times=0.7 probability=0.04;"
                                     "late times=0.8 probability=0.04; late times=1.2 probability=0.04"},
    FaultClass{"request late by 1.5", "late times=1.5 part=request probability=0.06"},
    FaultClass{"request late by 4 and 10",
               "late times=4 part=request probability=0.02; late times=10 part=request probability=0.02"},
    FaultClass{"lost request", "lost-request probability=0.08"},
    FaultClass{"lost answer", "lost-answer probability=0.08"},
    FaultClass{"request twice", "duplicate-request probability=0.1"},
    FaultClass{"answer twice", "duplicate-answer probability=0.1"},
    FaultClass{"echo", "echo probability=0.1"},
    FaultClass{"answer truncated", "truncate probability=0.08"},
    FaultClass{"request truncated", "truncate part=request probability=0.08"},
    FaultClass{"answer corrupted", "corrupt probability=0.05; corrupt bits=12 probability=0.05"},
    FaultClass{"request corrupted", "corrupt part=request probability=0.08"},
    FaultClass{"garbage after", "trailing probability=0.05; trailing bytes=40 probability=0.05"},
    FaultClass{"garbage after request", "trailing part=request probability=0.08"},
    FaultClass{"gaps of 2 and 20 characters",
               "gap characters=2 probability=0.06; gap characters=20 probability=0.06"},
    FaultClass{"gap in request", "gap characters=20 part=request probability=0.08"},
    FaultClass{"noise between", "noise bytes=1 probability=0.05; noise bytes=60 after=2 probability=0.05;"
                                "noise bytes=9 part=request probability=0.04"},
    FaultClass{"wrong unit", "wrong-unit probability=0.08"},
    FaultClass{"wrong function", "wrong-function probability=0.08"},
    FaultClass{"wrong count", "wrong-count probability=0.08"},
    FaultClass{"exceptions 1 to 6", "exception code=1 probability=0.02; exception code=2 probability=0.02;"
                                    "exception code=3 probability=0.02; exception code=4 probability=0.02;"
                                    "exception code=5 probability=0.02; exception code=6 probability=0.02"},
    FaultClass{"busy", "busy answers=3 probability=0.05"},
    FaultClass{"silence", "silence time=300 every=50"},
    FaultClass{"second master before", "second-master when=before probability=0.1"},
    FaultClass{"second master after", "second-master when=after probability=0.1"},
    FaultClass{"wrong baud", "wrong-baud time=200 every=60;"
                             "wrong-baud part=answer time=200 every=50"},
    FaultClass{"unplugged idle", "unplug when=idle time=200 every=50"},
    FaultClass{"unplugged in request", "unplug when=request time=200 every=50"},
    FaultClass{"unplugged in answer", "unplug when=answer time=200 every=50"},
    FaultClass{"back under another name", "unplug when=answer time=200 port=@other every=100;"
                                          "unplug when=idle time=200 port=@port every=50"},
    FaultClass{"restart", "restart time=200 every=50"},
    FaultClass{"other map version", "map-version major=2 probability=0.5", true},
    FaultClass{"other device", "device-type type=4660 probability=0.5", true},
    FaultClass{
        "all at once",
        "late times=1.5 probability=0.02; late times=0.7 probability=0.02; lost-request probability=0.01;"
        "lost-answer probability=0.01; duplicate-request probability=0.01; duplicate-answer probability=0.01;"
        "echo probability=0.01; truncate probability=0.01; corrupt probability=0.01; trailing "
        "probability=0.01;"
        "gap characters=20 probability=0.01; noise bytes=9 probability=0.01; wrong-unit probability=0.01;"
        "wrong-function probability=0.01; wrong-count probability=0.01; exception code=2 probability=0.01;"
        "busy probability=0.005; second-master when=before probability=0.01;"
        "second-master when=after probability=0.01; silence time=100 probability=0.001;"
        "unplug when=answer time=100 probability=0.001; restart time=100 probability=0.001"},
};

} // namespace campanel::soak
