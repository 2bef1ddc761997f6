vec3 offset, warpedPosition, warpedNormal;
{
  float t0 = position.x - (mouse.x - size.x / 2.0);
  float t1 = position.y - (mouse.y - size.y / 2.0);
  float t2 = exp((t0 * t0 + t1 * t1) / -16000.0);
  float t3 = t2 * ((t0 + t0) * -6.25e-5);
  float t4 = t2 * ((t1 + t1) * -6.25e-5);
  float t5 = position.x * 0.01 + millis / 600.0;
  float t6 = t0 * t4 * 0.6;
  float t7 = t1 * t3 * 0.6;
  float t8 = t4 * 90.0;
  float t9 = t3 * 90.0 + cos(t5) * 0.14;
  float t10 = (t2 + t0 * t3) * 0.6 + 1.0;
  float t11 = (t2 + t1 * t4) * 0.6 + 1.0;
  float t12 = (t10 * t11 - t7 * t6) * normal.z;
  float t13 = t11 * normal.x - t7 * normal.y + (t7 * t8 - t9 * t11) * normal.z;
  float t14 = t10 * normal.y - t6 * normal.x + (t9 * t6 - t10 * t8) * normal.z;
  float t15 = t13 * t13 + t14 * t14 + t12 * t12;
  float t16 = t15 > 0.0 ? inversesqrt(t15) : 0.0;
  offset = vec3(t0 * t2 * 0.6, t1 * t2 * 0.6, t2 * 90.0 + sin(t5) * 14.0);
  warpedPosition = position + offset;
  warpedNormal = vec3(t13 * t16, t14 * t16, t12 * t16);
}
