vec3 offset, warpedPosition, warpedNormal;
{
  float t0 = position.x * 0.34;
  float t1 = (position.y * -0.5 + 0.5) * bend;
  float t2 = 1.5 / bend;
  float t3 = position.x * 0.1156;
  float t4 = (t3 + t3) * 1.6;
  float t5 = t2 - (position.z * 0.04 - t0 * t0 * 1.6);
  float t6 = sin(t1);
  float t7 = cos(t1);
  offset = vec3(t0 - position.x, -t6 * t5 - position.y, t2 - t7 * t5 - position.z);
  float t8 = bend * -0.5;
  float t9 = t6 * t4;
  float t10 = t7 * t4;
  float t11 = t5 * (t7 * t8);
  float t12 = t5 * (t6 * t8);
  float t13 = t6 * -0.04;
  float t14 = t11 * -0.34 * normal.z - t6 * 0.0136 * normal.y;
  float t15 = t7 * -0.04;
  float t16 = t7 * 0.0136 * normal.y - t12 * 0.34 * normal.z;
  float t17 = (t11 * t15 + t12 * t13) * normal.x;
  float t18 = (t13 * t10 - t15 * t9) * normal.y;
  float t19 = (-t9 * t12 - t10 * t11) * normal.z;
  float t20 = t17 + t18 + t19;
  float t21 = t20 * t20 + t16 * t16 + t14 * t14;
  float t22 = t21 > 0.0 ? inversesqrt(t21) : 0.0;
  warpedNormal = vec3(t20 * t22, t16 * t22, t14 * t22);
  warpedPosition = position + offset;
}
