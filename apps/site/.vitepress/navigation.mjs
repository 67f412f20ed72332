/** Bars of the site, in the order that a reader needs the pages in. */

/** @param {string} text @param {string} link */
const page = (text, link) => ({ text, link });

/** @type {import('vitepress').DefaultTheme.Config} */
export const english = {
  nav: [
    page('Start', '/start'),
    page('Guides', '/guides/what-it-is'),
    page('Techniques', '/techniques/'),
    page('Gallery', '/gallery/'),
    page('Thesis', '/thesis/'),
  ],
  sidebar: {
    '/techniques/': [{ text: 'Techniques', items: [page('Compared', '/techniques/')] }],
    '/': [{ text: 'Start', items: [page('Start in a minute', '/start')] }],
  },
  outline: [2, 3],
};

/** @type {Partial<import('vitepress').LocaleSpecificConfig<import('vitepress').DefaultTheme.Config>>} */
export const spanish = {
  description: 'Dibuja escenas corrientes de three.js con cualquier número de luces, y las edita mientras corren.',
  themeConfig: {
    nav: [page('Inicio', '/es/start'), page('Tesis', '/es/thesis/')],
    sidebar: { '/es/': [{ text: 'Inicio', items: [page('Empezar en un minuto', '/es/start')] }] },
    outline: { level: [2, 3], label: 'En esta página' },
  },
};
