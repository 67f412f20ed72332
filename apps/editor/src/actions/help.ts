import { t } from '@farol/editing';
import type { Action } from '../api/Action';
import { type Language, languages } from '@farol/editing';
import { showLanguage, shownLanguage } from '../language/shownLanguage';

export const showPalette: Action = {
  id: 'help.palette',
  label: 'Search commands',
  keys: ['Ctrl+K'],
  inFields: true,
  icon: 'search',
  run: ({ dialogs }) => void dialogs.show({ kind: 'palette' }),
};

export const showKeys: Action = {
  id: 'help.keys',
  label: 'Keys',
  keys: ['?'],
  icon: 'keyboard',
  run: ({ dialogs }) => void dialogs.show({ kind: 'keys' }),
};

export const startTour: Action = {
  id: 'help.tour',
  label: 'Tour of the editor',
  icon: 'eye',
  run: ({ tour }) => tour.start(),
};

const REPOSITORY = 'https://github.com/farol-renderer/farol/tree/main';

const pages = [
  ['editor', "The editor's guide", 'apps/editor/docs/using.md'],
  ['renderer', 'Guide to techniques and lights', 'packages/renderer#readme'],
  ['microshaders', 'Guide to effects and microshaders', 'packages/renderer/docs/authoring.md'],
  ['limits', 'What the techniques cannot do', 'packages/renderer/docs/limits.md'],
  ['examples', 'Examples for your own page', 'apps/site/live/gallery'],
] as const;

/** One action for each page of the documentation, which opens in a new window. */
export const guides: readonly Action[] = pages.map(([name, label, path]) => ({
  id: `help.guide.${name}`,
  label,
  run: () => void window.open(`${REPOSITORY}/${path}`, '_blank', 'noopener,noreferrer'),
}));

const apps = [
  ['viewer', 'Viewer'],
  ['lab', 'Lab'],
  ['gallery', 'Gallery of examples'],
] as const;

/** One action for each other app of Farol, which opens in a new window. */
export const otherApps: readonly Action[] = apps.map(([app, label]) => ({
  id: `help.app.${app}`,
  label,
  run: async () => (await import('../files/readScene')).openBeside(app, t(label)),
}));

/** Shows version and licence. */
export const about: Action = {
  id: 'help.about',
  label: 'About Farol',
  icon: 'lamp',
  run: ({ dialogs }) => void dialogs.show({ kind: 'about' }),
};

/** One action for each language; the choice is remembered. */
export const chooseLanguage: readonly Action[] = Object.entries(languages).map(([language, label]) => ({
  id: `help.language.${language}`,
  label,
  async run({ preferences }) {
    await showLanguage(language as Language);
    preferences.setState({ language: language as Language });
  },
  checked: () => shownLanguage() === language,
}));
