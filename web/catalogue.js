/**
 * What the gallery shows, in order. `name` is the folder in examples/; `scripts` are those beside p5.warpjet, of one example or of
 * all in a section; those with three.js name the `background` of their page.
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
        text: 'Each vertex is turned about the fuselage, further the further it is from the middle. The highlights slide over the wings as they would on a plane that was built this way.',
      },
      {
        name: 'sine-sphere',
        figure: 'Figure 2',
        title: 'Four spheres',
        text: 'Top left the sphere as it is, top right moved but lit by its old normals, bottom left with the flat normals that a fragment shader can find. Bottom right has the exact normals, smooth wherever the warp is.',
      },
      {
        name: 'sine-cube',
        figure: 'Figure 3',
        title: 'Cube of sines',
        text: 'One sine for each axis makes a cube into jelly. Every face keeps normals of its own, so the edges stay as sharp as they were.',
      },
      {
        name: 'bunny',
        figure: 'Figure 4',
        title: 'Bunny, twisted and flattened',
        text: 'The Stanford bunny at rest, wrung around its upright axis, and pressed into the plane of y and z. Even pressed flat its normals are right: they all point straight out of the plane.',
      },
      {
        name: 'genie',
        figure: 'Figure 5',
        title: 'Genie',
        text: 'Each vertex flies along a Bézier curve into the spout, the nearest ones first. A curve whose time depends on the vertex would be no pleasure to differentiate by hand.',
      },
      {
        name: 'coarse-and-fine',
        figure: 'Figure 6',
        title: 'Coarse and fine',
        text: 'The same twist on a cube of 8 squares a face and on one of 1,600. A warp moves vertices only, so between them a coarse mesh stays straight.',
      },
      {
        name: 'lotus',
        figure: 'Figure 7a',
        title: 'Lotus',
        text: 'A warp costs nothing to repeat: every petal is the same sphere, flattened, curled and bent. A uniform tells each one how far to bend, and so the flower breathes.',
      },
      {
        name: 'spoon',
        figure: 'Figure 7b',
        title: 'Bent spoon',
        text: 'The neck follows the arc of a circle, and the bowl goes on straight where the arc ends. Polished metal forgives no wrong normal.',
      },
      {
        name: 'fingers',
        figure: 'Figure 7c',
        title: 'Wiggling fingers',
        text: 'A wave runs through world space and takes the fingers along, the tips furthest. The hand turns under it, and the wave keeps its direction.',
      },
      {
        name: 'text-bulge',
        figure: 'Figure 7d',
        title: 'Bulge at the mouse',
        text: 'Extruded letters swell where the mouse or a finger points. The mouse is an input of the warp like any other, here taken into world space.',
      },
      {
        name: 'carousel',
        figure: 'Figure 7e',
        title: 'Cloth carousel',
        text: 'Eight cloths hang from a ring, ripple, and trail behind as it turns. Each has a front and a back of its own, so the light falls right on both.',
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
        text: 'A plane displaced by a function of x and y, in a shader of the sketch’s own. gen writes the height and both its slopes, and the slopes make the normal.',
      },
      {
        name: 'tangent-plane',
        figure: 'Article',
        title: 'Two ways to a normal',
        text: 'Left the older way: rotate a plane until it touches the surface, and move two neighbours in it. On the front of the cube there is no axis to rotate about, and the light goes out; right, the exact normal needs no axis.',
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
        text: 'Left a fractal noise, in the middle the same noise looked up where noise has moved the point, right where that noise was itself moved. Nothing else turns clouds into marble.',
      },
      {
        name: 'domain-warping-colours',
        figure: 'q and r',
        title: 'Its insides as colours',
        text: 'On the way to its value the warp passes two vectors, and they know more about the pattern than the value does. The length of the first lets in cream, a coordinate of the second the sea; time drifts through both.',
      },
      {
        name: 'domain-warping-lit',
        figure: 'Gradient',
        title: 'The same in the light',
        text: 'The value is a height now, and its exact gradient, through three fractal noises, one inside the other, turns the normal. Every pixel has its own, so the lamp at the mouse finds every crease.',
      },
      {
        name: 'domain-warping-3d',
        figure: 'Offset',
        title: 'Three spheres of noise',
        text: 'The three levels as the relief of a sphere. The deeper the noise is nested, the faster its slope changes, and the light still follows every fold, since the normals are exact at each vertex.',
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
        text: 'Slices turn about an axis, the further the further they are along it.',
      },
      {
        name: 'deformer-bend',
        figure: 'bend',
        title: 'Bent',
        text: 'A straight bar follows an arc of constant length, and goes on straight beyond it.',
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
        text: 'Longer along an axis, and as much thinner across it that the volume stays.',
      },
      {
        name: 'deformer-bulge',
        figure: 'bulge',
        title: 'Swallowed',
        text: 'What is near a point, here along an axis, swells. Further away nothing moves.',
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
        text: 'Sinks to the ground and spreads there, the lower parts first.',
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
        text: 'Points move to the side, the further the higher they are.',
      },
      {
        name: 'deformer-noise',
        figure: 'noiseDisplace',
        title: 'Boulder',
        text: 'Bumps of noise along the normals, which become others as time goes by.',
      },
    ],
  },
  {
    title: 'Composition',
    source: 'Of warps from warpjet/deformers, or of your own',
    examples: [
      {
        name: 'composition',
        scripts: ['deformers'],
        figure: 'chain, add, blend, mask, inSpace',
        title: 'Warps made of warps',
        text: 'To twist and then to bend is something else than to bend and then to twist; added, neither sees what the other did. All end up as one function, and its normals are as exact as those of its parts.',
      },
    ],
  },
  {
    title: 'Displacement',
    source: 'That a surface turns, and its normal with it, counts for the light',
    examples: [
      {
        name: 'along-the-normal',
        figure: 'New',
        title: 'Along the normal',
        text: 'Bumps along the normal, which turns as one goes around the ring. Left that turning is left out, as it usually is; right it counts, and highlights sit where the surface really faces the light.',
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
        title: 'Terrain from a text',
        text: 'Octaves that turn and shrink, in the manner of Shadertoy, are the height of a plane. The text has a loop, a matrix and two functions, and says nothing of normals; the light is exact all the same.',
      },
      {
        name: 'glsl-waves',
        scripts: ['glsl'],
        figure: 'GLSL',
        title: 'Gerstner waves',
        text: 'Four waves carry the water round in circles, as they stand in many shaders: crests are sharp, troughs are wide, and the normal follows from the text.',
      },
      {
        name: 'glsl-noise',
        scripts: ['glsl'],
        figure: 'GLSL',
        title: 'Noise of a package',
        text: 'The simplex noise that half the web uses, read from its package as it is, displaces a sphere. Its derivative, which nobody wrote, turns the normal.',
      },
      {
        name: 'strands-exact-normals',
        scripts: ['glsl'],
        figure: 'p5.strands',
        title: 'Strands, before and after',
        text: 'A sketch in p5.strands with operators, an if and a loop. Left it is lit as if nothing had moved; right exactNormals has read the shader and turns its normals.',
      },
      {
        name: 'shadow-map',
        figure: 'createWarp',
        title: 'A shadow map',
        text: 'p5 has no shadows. Here the same warp goes onto two shaders of the sketch: one keeps how near to the light each place is, in a p5.Framebuffer, and the other is dark where something was nearer. The shadow sways with its tower.',
      },
      {
        name: 'ray-marched-field',
        scripts: ['glsl'],
        figure: 'differentiate',
        title: 'A field with its gradient',
        text: 'Blobs as a field of distances, ray-marched. Left the light takes four more evaluations of the field, right one of the function of value and gradient that was made of its text.',
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
        text: 'The sketch draws furrows into an image of 120 × 120 pixels, and the sand takes its grey for its height. The warp reads it as a cubic B-spline and differentiates just that, so the light glides over the ridges and shows no pixels.',
      },
      {
        name: 'marbled-paper',
        figure: 'Image',
        title: 'Marbled paper',
        text: 'Stripes of paint, stirred: each pixel looks up its colour where fractal noise has moved it, and that noise was moved by noise before. All of it happens in the fragment shader.',
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
        text: 'Four waves that go round in circles, as Gerstner found in 1804. Where foldover finds the water turned over it foams, and the boat asks inverseAt what of the calm sea has come under it.',
      },
      {
        name: 'three-grass',
        background: '#f3e3c8',
        figure: 'Instances',
        title: 'Grass in the wind',
        text: 'Ten thousand blades in one InstancedMesh, warped in the world, where the wind blows the same way for all of them. Noise wanders over the field, and light and shadows bend along.',
      },
      {
        name: 'three-terrain',
        background: '#c5d8e8',
        figure: 'Rays',
        title: 'Terrain to point at',
        text: 'A plane that ridged noise makes mountains of. The flag stands where the pointer meets them, upright on the slope; a click plants it. Drag to turn.',
      },
      {
        name: 'three-corridor',
        background: '#34405f',
        figure: 'Bones',
        title: 'Through a bending corridor',
        text: 'A skinned figure walks straight ahead, and one warp in the world takes it, the walls and the arches around a bend. Its shadow goes along, and the camera follows its bounds.',
      },
      {
        name: 'three-glass',
        background: '#b9b2a6',
        figure: 'Tangents',
        title: 'Glass',
        text: 'A vase of hammered glass, the hammering a map of normals. The warp turns the tangents of the vase with its normals, so that dents stay dents while flutes wind around it.',
      },
      {
        name: 'three-lanterns',
        background: '#070b18',
        figure: 'Culling',
        title: 'Ten thousand lanterns',
        text: 'Twenty-five tiles of four hundred lanterns each, on a swell. Three.js leaves out every tile that the warp takes out of sight; the small picture shows from above which it draws.',
      },
    ],
  },
]
