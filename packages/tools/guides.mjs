/**
 * Guides of the site in the order that a reader needs them in: names by file in `apps/site/pages/guides`, by group. The site's
 * bar and the editor's palette list them.
 *
 * @type {Readonly<Record<string, Readonly<Record<string, string>>>>}
 */
export const guides = {
  Start: {
    'create-farol': 'npm create farol',
    renderer: 'The renderer',
    faq: 'Questions',
    moving: 'Moving to Farol',
  },
  Lights: {
    lights: 'Lights and their ranges',
    shadows: 'Shadows',
    'light-fields': 'Lights as data',
    'pixel-lighting': 'Which lights made this pixel',
    particles: 'Particles',
    baking: 'Baking',
  },
  Pictures: {
    canvas: 'Canvas, size and targets',
    effects: 'Effects and bloom',
    'volumetric-fog': 'Fog that lights light',
    views: 'Views of what a frame is made of',
    'many-objects': 'Many objects',
    surfaces: 'Surfaces of microshaders',
    'frame-budget': 'A frame budget',
    learning: 'auto that learns',
  },
  'Where it runs': {
    'react-three-fiber': 'React Three Fiber',
    phones: 'Phones and tablets',
    headsets: 'Headsets',
  },
  'What to expect': {
    limits: 'Not as in stock three',
    accuracy: 'Accuracy',
    performance: 'Performance',
    promises: 'Promises',
    compatibility: 'Versions and browsers',
    lab: 'Measure on your GPU',
  },
  'Write your own': {
    authoring: 'Technique, effect, microshader',
    'engine-adding': 'Component, scene',
    attach: 'The editor in your page',
  },
  Engine: {
    engine: 'The engine',
    scenes: 'Demo scenes',
    'engine-headsets': 'Headsets',
    'engine-photometry': 'Light in real units',
    'scene-files': 'Scene files',
    models: 'OBJ, STL and PLY',
    guard: 'Files of strangers',
    'editing-package': 'Undo, fields and units',
  },
  Editor: {
    editor: 'The editor and its plugins',
    agent: 'Let an agent edit',
    'editor-files': 'Files and exports',
    'editor-editing': 'Editing',
    'editor-scripts': 'Scripts',
    'editor-animation': 'Timeline',
    'editor-viewport': 'Viewport',
    'editor-layout': 'Windows and panels',
    'editor-promises': 'Promises',
  },
  'How it is made': {
    architecture: 'One frame',
    'light-loops': 'Light loops',
    'shadow-maps': 'Shadow maps',
    'attempts/deferred': 'Attempts: deferred',
    'attempts/forward': 'Attempts: forward',
    'attempts/frame': 'Attempts: the frame',
    'attempts/enlarging': 'Attempts: enlarging',
    'attempts/shadow-lookups': 'Attempts: reading shadow maps',
    'attempts/shadow-casters': 'Attempts: casters',
    'attempts/shadow-regions': 'Attempts: regions of maps',
    'attempts/shadow-atlas': 'Attempts: the atlas',
    'attempts/antialiasing': 'Attempts: anti-aliasing',
    project: 'The repository',
    contributing: 'Working on Farol',
    site: 'This site',
    licences: 'Licences of others',
  },
};
