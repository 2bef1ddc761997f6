/** What the gallery shows, in order. `name` is the folder in examples/. */
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
]
