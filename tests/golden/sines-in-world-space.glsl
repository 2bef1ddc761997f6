vec3 offset, warpedPosition, warpedNormal;
{
  float t0 = millis / 1000.0;
  float t1 = t0 * 2.0 + position.y * 0.04;
  float t2 = t0 * 0.5 + position.z * 0.02;
  float t3 = t0 * 1.5 + position.x * 0.03;
  float t4 = cos(t3) * 0.45;
  offset = vec3(sin(t1) * 15.0, sin(t2) * 15.0, sin(t3) * 15.0);
  float t5 = cos(t1) * 0.6;
  float t6 = cos(t2) * 0.3;
  float t7 = normal.x + t6 * t4 * normal.y - t4 * normal.z;
  float t8 = normal.y - t5 * normal.x + t4 * t5 * normal.z;
  float t9 = t5 * t6 * normal.x - t6 * normal.y + normal.z;
  float t10 = t7 * t7 + t8 * t8 + t9 * t9;
  float t11 = t10 > 0.0 ? inversesqrt(t10) : 0.0;
  warpedNormal = vec3(t7 * t11, t8 * t11, t9 * t11);
  warpedPosition = position + offset;
}
