bool Both(bool a, bool b);
int Sign(int x);
