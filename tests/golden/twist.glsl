vec3 offset, warpedPosition, warpedNormal;
{
  float t0 = position.x * 0.02 + millis / 1000.0;
  float t1 = position.z + 500.0;
  float t2 = cos(t0);
  float t3 = sin(t0);
  vec3 t4 = vec3(normal.x - t1 * -0.02 * normal.y - position.y * 0.02 * normal.z, t2 * normal.y - t3 * normal.z, t3 * normal.y + t2 * normal.z);
  offset = vec3(0.0, position.y * t2 - t1 * t3 - position.y, position.y * t3 + t1 * t2 - 500.0 - position.z);
  float t5 = dot(t4, t4);
  float t6 = inversesqrt(t5);
  warpedNormal = t4 * (t5 > 0.0 ? t6 : 0.0);
  warpedPosition = position + offset;
}
