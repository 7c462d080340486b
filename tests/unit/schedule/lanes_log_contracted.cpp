// The same events of lanes that round products and sums at once, as the engine's do.
#define log_lanes log_contracted_lanes
#include "unit/schedule/lanes_log.cpp"
