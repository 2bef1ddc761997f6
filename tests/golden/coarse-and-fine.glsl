vec3 offset, warpedPosition, warpedNormal;
{
  float t0 = sin(millis / 1000.0);
  float t1 = position.y * 0.014 * t0;
  float t2 = t0 * 0.014;
  float t3 = sin(t1);
  float t4 = cos(t1);
  float t5 = position.x * t4 - position.z * t3;
  float t6 = position.x * t3 + position.z * t4;
  float t7 = t6 * t2;
  float t8 = t5 * t2;
  vec3 t9 = vec3(t4 * normal.x - t3 * normal.z, (t7 * t4 - t8 * t3) * normal.x + normal.y + (-t3 * t7 - t4 * t8) * normal.z, t3 * normal.x + t4 * normal.z);
  offset = vec3(t5 - position.x, 0.0, t6 - position.z);
  float t10 = dot(t9, t9);
  float t11 = t10 > 0.0 ? inversesqrt(t10) : 0.0;
  warpedNormal = t9 * t11;
  warpedPosition = position + offset;
}
