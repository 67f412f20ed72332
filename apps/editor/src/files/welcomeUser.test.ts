import { afterEach, expect, it, vi } from 'vitest';
import type { EditorApi } from '../api/EditorApi';
import { Dialogs } from '../model/Dialogs';
import { Notices } from '../model/Notices';
import { welcomeUser } from './welcomeUser';

afterEach(() => void vi.unstubAllGlobals());

it('the welcome page is shown once its code is there, and not to a user who has begun meanwhile', async () => {
  vi.stubGlobal('window', new EventTarget());
  const editor = { dialogs: new Dialogs(), notices: new Notices() } as unknown as EditorApi;
  const { dialogs } = editor;
  let fetched = (): void => {};
  const load = (): Promise<void> => new Promise((resolve) => (fetched = resolve));
  const shown = welcomeUser(editor, true, load)(null);
  expect(dialogs.current).toBeNull();
  fetched();
  await shown;
  expect(dialogs.current).toEqual({ kind: 'welcome', recovery: null });
  dialogs.close(false);

  const late = welcomeUser(editor, true, load)(null);
  window.dispatchEvent(new Event('keydown'));
  fetched();
  await late;
  expect(dialogs.current).toBeNull();

  // offline the dialog reports the missing code itself
  await welcomeUser(editor, true, () => Promise.reject(new Error('offline')))(null);
  expect(dialogs.current).toEqual({ kind: 'welcome', recovery: null });
});
