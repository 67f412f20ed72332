import { t } from '@farol/editing';
import { StrictMode } from 'react';
import { createRoot } from 'react-dom/client';
import { handleKey } from './actions/handleKey';
import { Editor } from './Editor';
import { fetchAhead } from './fetchAhead';
import { isLink } from './files/share/isLink';
import { welcomeUser } from './files/welcomeUser';
import { showLanguage } from './language/shownLanguage';
import { storedLanguage } from './language/storedLanguage';
import { Layout } from './panels/Layout';
import { startPlugins } from './plugins/startPlugins';
import './style/theme.css';
import './style/base.css';
import './style/controls.css';
import './style/pickers.css';
import './style/popups.css';
import './style/layout.css';
import { EditorProvider } from './ui/EditorContext';
import { InLanguage } from './ui/InLanguage';

declare global {
  interface Window {
    /** Exposed for tests and the console, see class Editor. */
    editor: Editor;
  }
}

/** Prefix of the editor's keys in localStorage. */
const STORAGE = 'farol-editor';

const place = document.getElementById('app')!;

/** @param problem - why the texts of the user's language could not be fetched; null when they were */
function start(problem: Error | null): void {
  const parameters = new URLSearchParams(location.search);
  const editor = new Editor(document.createElement('canvas'), {
    scene: isLink(location.hash) ? 'empty' : parameters.get('scene'),
    storage: STORAGE,
  });
  window.editor = editor;
  if (problem) editor.notices.show('warning', problem.message);
  editor.attempt(async () => (await import('./files/watchDrops')).watchDrops(editor));
  // a URL that names a scene suppresses the welcome page, unless it has ?welcome=yes
  const saysScene = isLink(location.hash) || parameters.has('scene');
  const welcomeChoice =
    parameters.get('welcome') ?? (saysScene || !editor.preferences.getState().showWelcome ? 'no' : 'yes');
  const offer = welcomeUser(editor, welcomeChoice === 'yes', () => import('./panels/welcome/Welcome'));
  const openLink = async (): Promise<void> => {
    const { decodeLink } = await import('./files/share/linkText');
    const text = await decodeLink(location.hash, editor.mayUnpack);
    await editor.openFileBytes(text, { name: null, handle: null });
  };
  const plugins = startPlugins(editor).catch((error: Error) => editor.notices.show('error', error.message, 'plugin'));
  // recovery waits for plugins, since a scene may have components of theirs
  const opened = Promise.allSettled([editor.ready, plugins]);
  const autosave = async (): Promise<void> => {
    const { startAutosave } = await import('./files/autosave/startAutosave');
    editor.autosave = await startAutosave(editor, opened, (recovery) => void recent.then(() => offer(recovery)));
  };
  const loadRecent = async (): Promise<void> => (await import('./files/recent/noteRecent')).loadRecent(editor);
  // without its code the welcome page shows no recent files
  const recent = loadRecent().catch(() => {});
  editor.attempt(autosave);
  void opened.then(() => {
    if (isLink(location.hash)) editor.attempt(openLink);
    if ('launchQueue' in window) void import('./files/openLaunched').then(({ openLaunched }) => openLaunched(editor));
    void fetchAhead().then((isFetched) => (editor.worksOffline = isFetched));
  });
  editor.ready.catch((error: Error) => editor.notices.show('error', error.message));
  for (const isCapture of [true, false]) {
    const keyDown = (event: KeyboardEvent): void => {
      if (!handleKey(editor, event, isCapture)) return;
      event.preventDefault();
      event.stopPropagation();
    };
    window.addEventListener('keydown', keyDown, isCapture);
  }
  window.addEventListener('beforeunload', (event) => editor.commands.isDirty && event.preventDefault());
  createRoot(place).render(
    <StrictMode>
      <EditorProvider value={editor}>
        <InLanguage>
          <Layout />
        </InLanguage>
      </EditorProvider>
    </StrictMode>,
  );
}

/** Starts the editor; an error is shown in its place. */
function tryStart(problem: Error | null): void {
  try {
    start(problem);
  } catch (error) {
    const reason = error instanceof Error ? error.message : String(error);
    place.innerHTML = '<main class="no-start" role="alert"><h1></h1><p></p></main>';
    place.querySelector('h1')!.textContent = t('Farol cannot start');
    place.querySelector('p')!.textContent = reason;
    throw error;
  }
}

const language = storedLanguage(STORAGE);
// English is built in: no texts are fetched
if (language === 'en') tryStart(null);
else {
  showLanguage(language).then(
    () => tryStart(null),
    (error: Error) => tryStart(error),
  );
}
