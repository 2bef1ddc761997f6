/**
 * The gallery's examples, in order. `name` is the folder in examples/; `scripts` lists the scripts that an example, or all examples of
 * a section, needs besides p5.warpjet; examples with three.js give the `background` of their page.
 */
export const sections = [
  {
    title: 'The figures of the paper',
    source: 'Pagurek van Mossel, Vertex Shader Domain Warping with Automatic Differentiation, 2024',
    examples: [
      {
        name: 'airplane-twist',
        figure: 'Figure 1',
        title: 'Airplane twist',
        text: 'Each vertex rotates about the fuselage, further the further it is from the middle. The highlights slide over the wings as they would on a plane built this way.',
      },
      {
        name: 'sine-sphere',
        figure: 'Figure 2',
        title: 'Four spheres',
        text: 'Top left: the original sphere. Top right: warped, but lit by its old normals. Bottom left: the flat normals that a fragment shader can compute. Bottom right: exact normals, smooth wherever the warp is.',
      },
      {
        name: 'sine-cube',
        figure: 'Figure 3',
        title: 'Cube of sines',
        text: 'One sine per axis turns a cube into jelly. Every face keeps its own normals, so the edges stay as sharp as they were.',
      },
      {
        name: 'bunny',
        figure: 'Figure 4',
        title: 'Bunny, twisted and flattened',
        text: 'The Stanford bunny at rest, wrung around its upright axis, and pressed into the plane of y and z. Even pressed flat, its normals are right: they all point straight out of the plane.',
      },
      {
        name: 'genie',
        figure: 'Figure 5',
        title: 'Genie',
        text: 'Each vertex flies along a Bézier curve into the spout, the nearest ones first. Differentiating a curve whose time depends on the vertex would be no pleasure by hand.',
      },
      {
        name: 'coarse-and-fine',
        figure: 'Figure 6',
        title: 'Coarse and fine',
        text: 'The same twist on a cube with 8 squares per face and on one with 1,600. A warp moves only vertices, so a coarse mesh stays straight between them.',
      },
      {
        name: 'one-edge-per-side',
        figure: 'Figure 6',
        title: 'One edge per side',
        text: 'A cube of 12 triangles, four times under one twist. Above, the twist has only corners to move. Below, the option detail divides the cube as finely as the picture needs. Left: normals at vertices. Right: exact normals at each pixel, which show the twist in the light even where the shape lacks it.',
      },
      {
        name: 'lotus',
        figure: 'Figure 7a',
        title: 'Lotus',
        text: 'A warp costs nothing to repeat: every petal is the same sphere, flattened, curled and bent. A uniform sets how far each one bends, so the flower breathes.',
      },
      {
        name: 'spoon',
        figure: 'Figure 7b',
        title: 'Bent spoon',
        text: 'The neck follows the arc of a circle, and the bowl goes on straight where the arc ends. Polished metal shows every wrong normal.',
      },
      {
        name: 'fingers',
        figure: 'Figure 7c',
        title: 'Wiggling fingers',
        text: 'A wave runs through world space and carries the fingers along, the tips furthest. The hand turns, but the wave keeps its direction.',
      },
      {
        name: 'text-bulge',
        figure: 'Figure 7d',
        title: 'Bulge at the mouse',
        text: 'Extruded letters swell where the mouse or a finger points. The mouse is an input of the warp like any other, here converted to world space.',
      },
      {
        name: 'carousel',
        figure: 'Figure 7e',
        title: 'Cloth carousel',
        text: 'Eight cloths hang from a ring, ripple, and trail behind as it turns. Each has a separate front and back, so both are lit correctly.',
      },
    ],
  },
  {
    title: 'The article before it',
    source: 'Pagurek, Deforming 3D shapes in real time, 2021',
    examples: [
      {
        name: 'displaced-plane',
        figure: 'Article',
        title: 'Displaced plane',
        text: 'A plane displaced by a function of x and y, in the sketch’s own shader. gen writes the height and both slopes, which give the normal.',
      },
      {
        name: 'tangent-plane',
        figure: 'Article',
        title: 'Two ways to a normal',
        text: 'Left: the older way, which rotates a plane until it touches the surface and displaces two neighbours in it. On the front of the cube there is no axis to rotate about, and the light goes out. Right: the exact normal needs no axis.',
      },
    ],
  },
  {
    title: 'Domain warping',
    source: 'Quilez, Domain warping, 2002',
    examples: [
      {
        name: 'domain-warping-2d',
        figure: 'f(g(p))',
        title: 'Noise moved by noise',
        text: 'Left: fractal noise. Middle: the same noise at points displaced by noise. Right: at points displaced by noise that is itself displaced. Nothing more is needed to turn clouds into marble.',
      },
      {
        name: 'domain-warping-colours',
        figure: 'q and r',
        title: 'Inner vectors as colours',
        text: 'On the way to its value the warp computes two vectors, which say more about the pattern than the value does. The length of the first mixes in cream, a coordinate of the second mixes in sea blue; time drifts through both.',
      },
      {
        name: 'domain-warping-lit',
        figure: 'Gradient',
        title: 'The value as a lit relief',
        text: 'The value is now a height, and its exact gradient, through three nested fractal noises, gives the normal. Every pixel has its own, so the lamp at the mouse finds every crease.',
      },
      {
        name: 'domain-warping-3d',
        figure: 'Offset',
        title: 'Three spheres of noise',
        text: 'The same three levels as the relief of a sphere. The deeper the noise is nested, the faster its slope changes, and the light still follows every fold, since the normals are exact at each vertex.',
      },
    ],
  },
  {
    title: 'Deformers',
    source:
      'From warpjet/deformers, ready made. Twist, taper, stretch and bend are those of Barr, Global and Local Deformations of Solid Primitives, 1984',
    scripts: ['deformers'],
    examples: [
      {
        name: 'deformer-twist',
        figure: 'twist',
        title: 'Wrung',
        text: 'Slices rotate about an axis, further the further they are along it.',
      },
      {
        name: 'deformer-bend',
        figure: 'bend',
        title: 'Bent',
        text: 'A straight bar follows an arc of constant length and continues straight beyond it.',
      },
      {
        name: 'deformer-taper',
        figure: 'taper',
        title: 'Tapered',
        text: 'Slices get narrower or wider along an axis; the one at the center keeps its size.',
      },
      {
        name: 'deformer-stretch',
        figure: 'stretch',
        title: 'Squash and stretch',
        text: 'Longer along an axis, and thinner across it, so that the volume stays the same.',
      },
      {
        name: 'deformer-bulge',
        figure: 'bulge',
        title: 'Swallowed',
        text: 'Swells the surface near a point, here along an axis. Nothing moves further away.',
      },
      {
        name: 'deformer-wave',
        figure: 'wave',
        title: 'Flying carpet',
        text: 'A plane wave travels along one direction and moves points along another.',
      },
      {
        name: 'deformer-ripple',
        figure: 'ripple',
        title: 'A drop of water',
        text: 'Rings travel away from a center and fade. The middle is round, not a spike.',
      },
      {
        name: 'deformer-melt',
        figure: 'melt',
        title: 'Chocolate bunny',
        text: 'Sinks to the ground and spreads there, lower parts first.',
      },
      {
        name: 'deformer-inflate',
        figure: 'inflate',
        title: 'Pumped up',
        text: 'Points move along their normals, by an amount that may vary over the shape.',
      },
      {
        name: 'deformer-genie',
        figure: 'genie',
        title: 'Into the Dock',
        text: 'A window narrows into a funnel and slides down it, into a point or an edge.',
      },
      {
        name: 'deformer-spherify',
        figure: 'spherify',
        title: 'Round',
        text: 'Blends towards a sphere, all the way or in part.',
      },
      {
        name: 'deformer-shear',
        figure: 'shear',
        title: 'Italics',
        text: 'Points move sideways, further the higher they are.',
      },
      {
        name: 'deformer-noise',
        figure: 'noiseDisplace',
        title: 'Boulder',
        text: 'Bumps of noise along the normals, which change over time.',
      },
    ],
  },
  {
    title: 'Composition',
    source: 'Compose warps from warpjet/deformers, or your own',
    examples: [
      {
        name: 'composition',
        scripts: ['deformers'],
        figure: 'chain, add, blend, mask, inSpace',
        title: 'Warps made of warps',
        text: 'Twisting and then bending differs from bending and then twisting; added, neither is affected by the other. All become one function, and its normals are as exact as those of its parts.',
      },
    ],
  },
  {
    title: 'Displacement',
    source: 'A surface turns, and so must its normal, or the light is wrong',
    examples: [
      {
        name: 'along-the-normal',
        figure: 'New',
        title: 'Along the normal',
        text: 'Bumps along the normal, which turns around the ring. Left: that turning is ignored, as in most shaders. Right: it is included, and the highlights are where the surface really faces the light.',
      },
    ],
  },
  {
    title: 'Shader text',
    source:
      'Read by warpjet/glsl; Gerstner waves after Gerstner, 1809; simplex noise by Gustavson and McEwan',
    examples: [
      {
        name: 'glsl-terrain',
        scripts: ['glsl'],
        figure: 'GLSL',
        title: 'Terrain from source',
        text: 'Rotated and shrinking octaves, as on Shadertoy, are the height of a plane. The source has a loop, a matrix and two functions, and no normals; the light is exact all the same.',
      },
      {
        name: 'glsl-waves',
        scripts: ['glsl'],
        figure: 'GLSL',
        title: 'Gerstner waves',
        text: 'Four waves move the water in circles, as in many shaders: crests are sharp, troughs are wide, and the normal follows from the source.',
      },
      {
        name: 'glsl-noise',
        scripts: ['glsl'],
        figure: 'GLSL',
        title: 'Noise from a package',
        text: 'The simplex noise that half the web uses, read unchanged from its package, displaces a sphere. Its derivative, which nobody wrote, gives the normal.',
      },
      {
        name: 'strands-exact-normals',
        scripts: ['glsl'],
        figure: 'p5.strands',
        title: 'Strands, before and after',
        text: 'A sketch in p5.strands with operators, an if and a loop. Left: lit as if nothing had moved. Right: exactNormals has read the shader and transforms its normals.',
      },
      {
        name: 'shadow-map',
        figure: 'createWarp',
        title: 'A shadow map',
        text: 'p5 has no shadows. Here two shaders of the sketch use the same warp: one stores each point’s distance to the light in a p5.Framebuffer, the other darkens points behind a nearer one. The shadow sways with its tower.',
      },
      {
        name: 'ray-marched-field',
        scripts: ['glsl'],
        figure: 'differentiate',
        title: 'A field with its gradient',
        text: 'Blobs as a distance field, ray-marched. Left: the light takes four more evaluations of the field. Right: one evaluation of a function that returns value and gradient, generated from the field’s source.',
      },
    ],
  },
  {
    title: 'Images as functions',
    source:
      'Interpolants of Keys, 1981, and of Sigg and Hadwiger, 2005; domain warping by Inigo Quilez, 2002',
    examples: [
      {
        name: 'raked-sand',
        figure: 'Heights',
        title: 'Raked sand',
        text: 'The sketch draws furrows into an image of 120 × 120 pixels, whose grey values are the height of the sand. The warp reads it as a cubic B-spline and differentiates exactly that, so the light glides over the ridges and shows no pixels.',
      },
      {
        name: 'marbled-paper',
        figure: 'Image',
        title: 'Marbled paper',
        text: 'Stripes of paint, stirred: each pixel looks up its colour at a point displaced by fractal noise, which is itself displaced by noise. All of it happens in the fragment shader.',
      },
    ],
  },
  {
    title: 'With three.js',
    source: 'warpjet/three: one line, and light, shadows, rays and culling follow',
    host: 'three',
    examples: [
      {
        name: 'three-sea',
        background: '#ced5d8',
        figure: 'Waves',
        title: 'Sea',
        text: 'Four waves that move the water in circles, as Gerstner found in 1804. It foams where foldover finds the water turned over, and the boat uses inverseAt to find the point of the calm sea below it.',
      },
      {
        name: 'three-raging-sea',
        background: '#150a24',
        figure: 'TSL',
        title: 'A raging sea, before and after',
        text: 'The waves of an example of three.js, as nodes. Left: normals from two more heights, each at a shifted place. Right: exactNormals reads the height from the shader and differentiates it. Change the shift: only the left half depends on it.',
      },
      {
        name: 'three-grass',
        background: '#f3e3c8',
        figure: 'Instances',
        title: 'Grass in the wind',
        text: 'Ten thousand blades in one InstancedMesh, warped in the world, where the wind blows in the same direction for all of them. Noise drifts over the field, and light and shadows bend along.',
      },
      {
        name: 'three-terrain',
        background: '#c5d8e8',
        figure: 'Rays',
        title: 'Terrain to point at',
        text: 'Ridged noise turns a plane into mountains. The flag marks the point under the pointer, upright on the slope; a click plants it. Drag to turn.',
      },
      {
        name: 'three-corridor',
        background: '#34405f',
        figure: 'Bones',
        title: 'Through a bending corridor',
        text: 'A skinned figure walks straight ahead, and one warp in world space leads it, the walls and the arches around a bend. Its shadow follows, and so does the camera, by its bounds.',
      },
      {
        name: 'three-glass',
        background: '#b9b2a6',
        figure: 'Tangents',
        title: 'Glass',
        text: 'A vase of hammered glass, whose dents are a normal map. The warp transforms the vase’s tangents with its normals, so that dents stay dents while flutes wind around it.',
      },
      {
        name: 'three-lanterns',
        background: '#070b18',
        figure: 'Culling',
        title: 'Ten thousand lanterns',
        text: 'Twenty-five tiles of four hundred lanterns each, on a swell. three.js skips every tile that the warp moves out of view; the small picture shows from above which ones it draws.',
      },
    ],
  },
]
