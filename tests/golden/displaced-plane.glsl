float height, slopeX, slopeY;
{
  float t0 = x * x + y * y + 0.002;
  float t1 = sqrt(t0);
  float t2 = 0.5 / t1;
  float t3 = t0 > 0.0 ? t2 : 0.0;
  float t4 = t1 * 8.0 + 1.0;
  float t5 = t1 * 26.0 - time * 3.0;
  float t6 = sin(t5) / t4;
  float t7 = cos(t5);
  float t8 = x * 5.0 + time;
  float t9 = y * 4.0;
  float t10 = t3 * (x * 2.0);
  float t11 = t3 * (y * 2.0);
  float t12 = (t7 * (t10 * 26.0) - t6 * (t10 * 8.0)) / t4 * 0.06;
  float t13 = (t7 * (t11 * 26.0) - t6 * (t11 * 8.0)) / t4 * 0.06;
  float t14 = sin(t8);
  slopeY = t13 + t14 * (sin(t9) * -4.0) * 0.05;
  float t15 = cos(t9);
  height = t6 * 0.06 + t14 * t15 * 0.05;
  slopeX = t12 + t15 * (cos(t8) * 5.0) * 0.05;
}
