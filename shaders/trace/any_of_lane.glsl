// On devices whose lanes leave loops one by one: the lane's own answer.
bool anyOfSubgroup(bool x) { return x; }
