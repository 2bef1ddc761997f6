// Valid and invalid statements in fragment shaders.
import { makeCases, withBody } from './sources.js'

/** Maps the title of a case → statements of a fragment shader. */
export const rulesOfFragments = Object.fromEntries(
  makeCases(
    'a fragment',
    [
      'gl_FragColor = vec4(1.0);',
      'gl_FragData[0] = vec4(1.0);',
      'gl_FragData[1] = vec4(1.0);',
      'gl_FragData[99] = vec4(1.0);',
      'gl_FragData[-1] = vec4(1.0);',
      'gl_FragData[0].x = 1.0;',
      'gl_FragData = 1.0;',
      'gl_FragColor.x = 1.0;',
      'gl_FragColor = gl_FragData[0];',
      'float x = gl_FragCoord.x;',
      'gl_FragCoord.x = 1.0;',
      'bool b = gl_FrontFacing;',
      'gl_FrontFacing = true;',
      'vec2 x = gl_PointCoord;',
      'gl_PointCoord.x = 1.0;',
      'gl_FragDepth = 1.0;',
      'float x = gl_FragDepth;',
      'int n = gl_MaxDrawBuffers;',
      'for (int i = 0; i < gl_MaxDrawBuffers; i++) gl_FragData[i] = vec4(1.0);',
      'int i = int(p.x); gl_FragData[i] = vec4(1.0);',
      'gl_FragData[gl_MaxDrawBuffers - 1] = vec4(1.0);',
      'gl_FragData[gl_MaxDrawBuffers] = vec4(1.0);',
      'gl_Position = vec4(1.0);',
      'gl_PointSize = 1.0;',
      'int i = gl_VertexID;',
    ],
    (statement) => withBody(statement),
  ),
)
