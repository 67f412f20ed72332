/** Sidebars of the site, in the order that a reader needs the pages in. */
import { guides as guidePages } from '@farol/tools/guides';

/** @param {string} text @param {string} link */
const page = (text, link) => ({ text, link });

const guides = Object.entries(guidePages).map(([text, pages]) => ({
  text,
  items: [
    ...(text === 'Start' ? [page('Get started in a minute', '/start')] : []),
    ...Object.entries(pages).map(([file, name]) => page(name, `/guides/${file}`)),
  ],
}));

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
 * Sidebar of the thesis's pages.
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
