import { beforeEach, expect, test, vi } from 'vitest';
import type { EditorApi, OpenFile } from '../api/EditorApi';
import { seenFile } from '../files/seenFile';
import { ConsoleLog } from '../model/ConsoleLog';
import { type ConfirmDialog, Dialogs } from '../model/Dialogs';
import { EditorDocument } from '../model/EditorDocument';
import { Notices } from '../model/Notices';
import { save } from './file';

/** Result of the fake file picker. */
let picked: FileSystemFileHandle | null = null;

vi.mock('browser-fs-access', () => ({
  fileSave: async (content: Blob, _options: object, handle: FileSystemFileHandle | null) => {
    const target = handle ?? picked!;
    const stream = await target.createWritable();
    await stream.write(content);
    return target;
  },
}));

/** A fake file on disk, which other programs also write. */
class DiskFile {
  writes = 0;
  lastModified = 1;

  constructor(
    readonly name: string,
    public text: string,
  ) {}

  readonly getFile = (): Promise<File> =>
    Promise.resolve(new File([this.text], this.name, { lastModified: this.lastModified }));

  readonly createWritable = (): Promise<object> =>
    Promise.resolve({
      write: async (content: Blob) => {
        this.text = await content.text();
        this.writes++;
      },
    });

  get handle(): FileSystemFileHandle {
    return this as unknown as FileSystemFileHandle;
  }
}

/** A stub of an editor with an open file, enough for saving. */
async function editorOf(disk: DiskFile): Promise<{ editor: EditorApi; said: () => string[] }> {
  const document = new EditorDocument();
  const log = new ConsoleLog();
  const bytes = new Uint8Array(await (await disk.getFile()).arrayBuffer());
  let file: OpenFile = await seenFile(bytes, { name: disk.name, handle: disk.handle });
  const editor = {
    document,
    commands: document.commands,
    dialogs: new Dialogs(),
    log,
    notices: new Notices(log),
    recentFiles: { list: [] },
    get file() {
      return file;
    },
    saved: (next: OpenFile) => void (file = next),
  } as unknown as EditorApi;
  return { editor, said: () => editor.notices.current.map(({ text }) => text) };
}

let disk: DiskFile;
beforeEach(() => {
  disk = new DiskFile('scene.json', '{"first": 1}');
  picked = null;
});

/** Waits for a question other than `known`. */
const question = ({ dialogs }: EditorApi, known: ConfirmDialog | null = null): Promise<ConfirmDialog> =>
  new Promise((resolve) => {
    const look = (): void => {
      const { current } = dialogs;
      if (current?.kind !== 'confirm' || current === known) return;
      end();
      resolve(current);
    };
    const end = dialogs.changed.subscribe(look);
    look();
  });

test('a file that is as it was opened, or as it was saved last, is saved without a question', async () => {
  const { editor, said } = await editorOf(disk);
  // another program has changed the time, but not the content
  disk.lastModified = 2;
  await save.run(editor);
  await save.run(editor);
  expect(disk.writes).toBe(2);
  expect(said()).toContain('Saved scene.json');
});

test('a file that another has changed is not saved over before the user says so', async () => {
  const { editor, said } = await editorOf(disk);
  await save.run(editor);
  disk.text = '{"other": 1}';
  const cancelled = Promise.resolve(save.run(editor));
  expect((await question(editor)).text).toContain('“scene.json”');
  editor.dialogs.close(false);
  await expect(cancelled).rejects.toMatchObject({ name: 'AbortError' });
  expect(disk.text).toBe('{"other": 1}');
  expect(disk.writes).toBe(1);

  // changed again, to content of the same size, while the question is open
  const saved = Promise.resolve(save.run(editor));
  const first = await question(editor);
  disk.text = '{"third": 1}';
  editor.dialogs.close(true);
  await question(editor, first);
  expect(disk.text).toBe('{"third": 1}');
  editor.dialogs.close(true);
  await saved;
  expect(disk.writes).toBe(2);
  await save.run(editor);
  expect(disk.writes).toBe(3);
  expect(said()).toContain('Saved scene.json');
});

test('it is saved under another name where that is chosen', async () => {
  const { editor } = await editorOf(disk);
  disk.text = '{"other": 1}';
  const other = new DiskFile('mine.json', '');
  picked = other.handle;
  const saved = Promise.resolve(save.run(editor));
  (await question(editor)).other!.choose();
  editor.dialogs.close(false);
  await saved;
  expect(disk.text).toBe('{"other": 1}');
  expect(editor.file.handle).toBe(other.handle);
  await save.run(editor);
  expect(other.writes).toBe(2);
});

test('a draft that was recovered knows its file as it was then; one of before that asks', async () => {
  const { editor } = await editorOf(disk);
  editor.saved({ name: disk.name, handle: disk.handle }, null);
  const saved = Promise.resolve(save.run(editor));
  await question(editor);
  editor.dialogs.close(false);
  await expect(saved).rejects.toMatchObject({ name: 'AbortError' });
  expect(disk.writes).toBe(0);
});
