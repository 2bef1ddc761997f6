vec3 offset, warpedPosition, warpedNormal;
{
  float t0 = position.x - (mouse.x - size.x / 2.0);
  float t1 = position.y - (mouse.y - size.y / 2.0);
  float t2 = exp((t0 * t0 + t1 * t1) / -16000.0);
  float t3 = t0 * 2.0;
  float t4 = t1 * 2.0;
  float t5 = t2 * -6.25e-5;
  float t6 = position.x * 0.01 + millis / 600.0;
  float t7 = t2 * -0.005625;
  float t8 = t5 * t3;
  float t9 = t5 * t4;
  float t10 = t7 * t3 + cos(t6) * 0.14;
  float t11 = t7 * t4;
  offset = vec3(t0 * t2 * 0.6, t1 * t2 * 0.6, t2 * 90.0 + sin(t6) * 14.0);
  float t12 = t1 * t8 * 0.6;
  float t13 = (t2 + t0 * t8) * 0.6 + 1.0;
  float t14 = (t2 + t1 * t9) * 0.6 + 1.0;
  float t15 = t0 * t9 * 0.6;
  vec3 t16 = vec3(t14 * normal.x - t12 * normal.y + (t12 * t11 - t10 * t14) * normal.z, t13 * normal.y - t15 * normal.x + (t10 * t15 - t13 * t11) * normal.z, (t13 * t14 - t12 * t15) * normal.z);
  float t17 = dot(t16, t16);
  vec3 t18 = t16 * inversesqrt(t17);
  warpedNormal = t17 > 0.0 && t17 < 1e38 ? t18 : vec3(0.0);
  warpedPosition = position + offset;
}
