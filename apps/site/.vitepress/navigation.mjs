/** Bars of the site, in the order that a reader needs the pages in. */

/** @param {string} text @param {string} link */
const page = (text, link) => ({ text, link });

/** @param {string} text @param {Record<string, string>} pages - names by file in guides/ */
const group = (text, pages) => ({
  text,
  items: Object.entries(pages).map(([file, name]) => page(name, `/guides/${file}`)),
});

const guides = [
  {
    text: 'Start',
    items: [
      page('Start in a minute', '/start'),
      ...group('', {
        'create-farol': 'npm create farol',
        renderer: 'The renderer',
        faq: 'Questions',
        moving: 'Moving to Farol',
      }).items,
    ],
  },
  group('Lights', {
    lights: 'Lights and their ranges',
    shadows: 'Shadows',
    'light-fields': 'Lights as data',
    particles: 'Particles',
    baking: 'Baking',
  }),
  group('Pictures', {
    canvas: 'Canvas, size and targets',
    effects: 'Effects and bloom',
    'volumetric-fog': 'Fog that lights light',
    views: 'Views of what a frame is made of',
    'many-objects': 'Many objects',
    surfaces: 'Surfaces of microshaders',
    'frame-budget': 'A frame budget',
    learning: 'auto that learns',
  }),
  group('Where it runs', {
    'react-three-fiber': 'React Three Fiber',
    phones: 'Phones and tablets',
    headsets: 'Headsets',
  }),
  group('What to expect', {
    limits: 'Not as in stock three',
    accuracy: 'Accuracy',
    performance: 'Performance',
    promises: 'Promises',
    compatibility: 'Versions and browsers',
    lab: 'Measure on your GPU',
  }),
  group('Write your own', {
    authoring: 'Technique, effect, microshader',
    'engine-adding': 'Component, scene',
    attach: 'The editor in your page',
  }),
  group('Engine', {
    engine: 'The engine',
    scenes: 'Demo scenes',
    'engine-headsets': 'Headsets',
    'engine-photometry': 'Light in real units',
    'scene-files': 'Scene files',
    models: 'OBJ, STL and PLY',
    guard: 'Files of strangers',
    'editing-package': 'Undo, fields and units',
  }),
  group('Editor', {
    editor: 'The editor and its plugins',
    agent: 'Let an agent edit',
    'editor-files': 'Files and exports',
    'editor-editing': 'Editing',
    'editor-scripts': 'Scripts',
    'editor-animation': 'Timeline',
    'editor-viewport': 'Viewport',
    'editor-layout': 'Windows and panels',
    'editor-promises': 'Promises',
  }),
  group('How it is made', {
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
  }),
];

/** Techniques by file in techniques/, in the order of their complexity. */
export const techniqueNames = {
  auto: 'Automatic',
  forward: 'Forward, multipass',
  'forward-single-pass': 'Forward, single pass',
  deferred: 'Deferred shading',
  'light-prepass': 'Light pre-pass',
  inferred: 'Inferred lighting',
  'tiled-forward': 'Tiled forward',
  'tiled-deferred': 'Tiled deferred',
  'forward-plus': 'Forward+',
  'clustered-forward': 'Clustered forward',
  'clustered-deferred': 'Clustered deferred',
};

const techniques = [
  {
    text: 'Techniques',
    items: [
      page('All compared', '/techniques/'),
      ...Object.entries(techniqueNames).map(([file, name]) => page(name, `/techniques/${file}`)),
    ],
  },
];

/**
 * Bar of the thesis's pages.
 *
 * @param {string} text
 * @param {string} folder
 * @param {string} first - name of the page of contents
 * @param {Record<string, string>} pages - names by file
 */
const thesis = (text, folder, first, pages) => [
  {
    text,
    items: [page(first, folder), ...Object.entries(pages).map(([file, name]) => page(name, `${folder}${file}`))],
  },
];

const englishThesis = thesis('The living thesis', '/thesis/', 'Contents', {
  'light-and-shading': 'Light and shading',
  multipass: 'Many lights, pass by pass',
  deferred: 'Deferred rendering',
  variants: 'The variants',
  'engine-design': 'Design of the engine',
  scenes: 'Scenes',
  results: 'Results',
  errors: 'Errors and their cure',
  'future-work': 'Future work',
});
const spanishThesis = thesis('La tesis viva', '/es/thesis/', 'Contenido', {
  'light-and-shading': 'Luz y sombreado',
  multipass: 'Muchas luces, pasada a pasada',
  deferred: 'Deferred rendering',
  variants: 'Las variantes',
  'engine-design': 'Diseño del engine',
  scenes: 'Escenas',
  results: 'Resultados',
  errors: 'Errores y su remedio',
  'future-work': 'Trabajo futuro',
});

/** English pages by group, in the reader's order. */
export const groups = [...guides, ...techniques, ...englishThesis];

export const english = {
  nav: [
    page('Get started', '/start'),
    page('Guides', '/guides/lights'),
    page('Techniques', '/techniques/'),
    page('Gallery', '/gallery/'),
    page('API', '/api/'),
    page('Thesis', '/thesis/'),
  ],
  sidebar: { '/techniques/': techniques, '/gallery/': [], '/thesis/': englishThesis, '/': guides },
  outline: [2, 3],
};

/** Spanish pages, then the groups of those that are English alone. */
const guias = [
  {
    text: 'Inicio',
    items: [page('Empezar en un minuto', '/es/start'), page('Luces y sus alcances', '/es/guides/lights')],
  },
  {
    text: 'Técnicas',
    items: [page('Comparadas', '/es/techniques/')],
  },
  ...[...guides, ...techniques].map(({ text, items }) => ({ text: `${text} (en inglés)`, items })),
];

export const spanish = {
  description: 'Dibuja escenas corrientes de three.js con cualquier número de luces, y las edita mientras corren.',
  themeConfig: {
    nav: [
      page('Inicio', '/es/start'),
      page('Luces', '/es/guides/lights'),
      page('Técnicas', '/es/techniques/'),
      page('Galería', '/es/gallery/'),
      page('API', '/api/'),
      page('Tesis', '/es/thesis/'),
    ],
    sidebar: { '/es/thesis/': spanishThesis, '/es/gallery/': [], '/es/': guias },
    outline: { level: [2, 3], label: 'En esta página' },
    docFooter: { prev: 'Página anterior', next: 'Página siguiente' },
    darkModeSwitchLabel: 'Apariencia',
    lightModeSwitchTitle: 'Tema claro',
    darkModeSwitchTitle: 'Tema oscuro',
    sidebarMenuLabel: 'Menú',
    returnToTopLabel: 'Volver arriba',
    langMenuLabel: 'Idioma',
    skipToContentLabel: 'Saltar al contenido',
  },
};
