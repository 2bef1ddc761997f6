vec3 offset, warpedPosition, warpedNormal;
{
  float t0 = position.y * 6.0 + millis / 1500.0;
  float t1 = sin(t0) * 0.6;
  float t2 = cos(t0) * 3.6;
  float t3 = sin(t1);
  float t4 = cos(t1);
  vec3 t5 = vec3(t4 * normal.x - t3 * normal.z, position.z * t2 * normal.x + normal.y - position.x * t2 * normal.z, t3 * normal.x + t4 * normal.z);
  offset = vec3(position.x * t4 - position.z * t3 - position.x, 0.0, position.x * t3 + position.z * t4 - position.z);
  float t6 = dot(t5, t5);
  float t7 = inversesqrt(t6);
  warpedNormal = t5 * (t6 > 0.0 ? t7 : 0.0);
  warpedPosition = position + offset;
}
