vec3 offset, warpedPosition, warpedNormal;
{
  float t0 = position.x * 0.02 + millis / 1000.0;
  float t1 = position.z + 500.0;
  float t2 = cos(t0);
  float t3 = sin(t0);
  float t4 = position.y * t2 - t1 * t3;
  float t5 = position.y * t3 + t1 * t2;
  float t6 = t5 * -0.02;
  offset = vec3(0.0, t4 - position.y, t5 - 500.0 - position.z);
  float t7 = t4 * 0.02;
  vec3 t8 = vec3(normal.x + (-t3 * t7 - t2 * t6) * normal.y + (t6 * t3 - t7 * t2) * normal.z, t2 * normal.y - t3 * normal.z, t3 * normal.y + t2 * normal.z);
  float t9 = dot(t8, t8);
  float t10 = t9 > 0.0 ? inversesqrt(t9) : 0.0;
  warpedNormal = t8 * t10;
  warpedPosition = position + offset;
}
