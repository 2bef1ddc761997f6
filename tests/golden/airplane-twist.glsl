vec3 offset, warpedPosition, warpedNormal;
{
  float t0 = sin(millis / 1200.0);
  float t1 = t0 * position.x * 0.015;
  float t2 = t0 * 0.015;
  float t3 = sin(t1);
  float t4 = cos(t1);
  float t5 = position.y * t4 - position.z * t3;
  float t6 = position.y * t3 + position.z * t4;
  float t7 = t6 * t2;
  float t8 = t5 * t2;
  vec3 t9 = vec3(normal.x + (t4 * t7 - t3 * t8) * normal.y + (-t7 * t3 - t8 * t4) * normal.z, t4 * normal.y - t3 * normal.z, t3 * normal.y + t4 * normal.z);
  offset = vec3(0.0, t5 - position.y, t6 - position.z);
  float t10 = dot(t9, t9);
  float t11 = t10 > 0.0 ? inversesqrt(t10) : 0.0;
  warpedNormal = t9 * t11;
  warpedPosition = position + offset;
}
