float height, slopeX, slopeY;
{
  float t0 = x * x + y * y + 0.002;
  float t1 = sqrt(t0);
  float t2 = t0 > 0.0 ? 0.5 / t1 : 0.0;
  float t3 = t1 * 8.0 + 1.0;
  float t4 = t1 * 26.0 - time * 3.0;
  float t5 = sin(t4) / t3;
  float t6 = cos(t4);
  float t7 = x * 5.0 + time;
  float t8 = y * 4.0;
  float t9 = t2 * (x * 2.0);
  float t10 = t2 * (y * 2.0);
  float t11 = (t6 * (t9 * 26.0) - t5 * (t9 * 8.0)) / t3 * 0.06;
  float t12 = (t6 * (t10 * 26.0) - t5 * (t10 * 8.0)) / t3 * 0.06;
  float t13 = sin(t7);
  slopeY = t12 + t13 * (sin(t8) * -4.0) * 0.05;
  float t14 = cos(t8);
  height = t5 * 0.06 + t13 * t14 * 0.05;
  slopeX = t11 + t14 * (cos(t7) * 5.0) * 0.05;
}
