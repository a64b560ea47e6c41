#include "channel_a/measured.hpp"

bool Both(bool a, bool b)
{
    return a && b;
}

int Sign(int x)
{
    if (x < 0)
    {
        return -1;
    }
    return 1;
}
