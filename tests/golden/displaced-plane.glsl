float height, slopeX, slopeY;
{
  float t0 = x * x + y * y + 0.002;
  float t1 = sqrt(t0);
  float t2 = t1 * 8.0 + 1.0;
  float t3 = t1 * 26.0 - time * 3.0;
  float t4 = cos(t3);
  float t5 = sin(t3) / t2;
  float t6 = t5 / t2;
  float t7 = x * 5.0 + time;
  float t8 = sin(t7);
  float t9 = y * 4.0;
  float t10 = cos(t9);
  height = t5 * 0.06 + t8 * t10 * 0.05;
  float t11 = t0 > 0.0 ? 0.5 / t1 : 0.0;
  float t12 = t11 * (x + x);
  slopeX = (t4 * (t12 * 26.0) / t2 - t6 * (t12 * 8.0)) * 0.06 + t10 * (cos(t7) * 5.0) * 0.05;
  float t13 = t11 * (y + y);
  slopeY = (t4 * (t13 * 26.0) / t2 - t6 * (t13 * 8.0)) * 0.06 + t8 * (sin(t9) * -4.0) * 0.05;
}
