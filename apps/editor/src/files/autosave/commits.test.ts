import { Signal } from '@farol/editing';
import { GameObject } from '@farol/engine';
import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import type { EditorApi } from '../../api/EditorApi';
import { addObject } from '../../model/edits';
import { EditorDocument } from '../../model/EditorDocument';
import { Autosave } from './Autosave';
import type { AutosaveStore } from './AutosaveStore';
import type { WorkerRequest } from './messages';

/** Pending timers and idle callbacks, by number. */
const waiting = new Map<number, () => void>();
let count = 0;
const wait = (run: () => void): number => {
  waiting.set(++count, run);
  return count;
};

/** Runs timers and idle callbacks until none is left, with the promises that they resolve. */
async function settle(): Promise<void> {
  for (let i = 0; i < 10; i++) await Promise.resolve();
  while (waiting.size > 0) {
    const [[id, run]] = waiting;
    waiting.delete(id);
    run();
    for (let i = 0; i < 10; i++) await Promise.resolve();
  }
}

beforeEach(() => {
  waiting.clear();
  const listens = { addEventListener: () => {} };
  const requestIdleCallback = (run: (idle: null) => void): number => wait(() => run(null));
  vi.stubGlobal('window', {
    ...listens,
    document: { ...listens, hidden: false },
    setTimeout: wait,
    requestIdleCallback,
  });
  vi.stubGlobal('requestIdleCallback', requestIdleCallback);
  vi.stubGlobal('clearTimeout', (id: number) => waiting.delete(id));
  vi.stubGlobal('navigator', { locks: { request: () => Promise.resolve() } });
});
afterEach(() => vi.unstubAllGlobals());

/** An autosave whose commits the test answers, in the order of `commits`. */
function open() {
  const document = new EditorDocument();
  const requests: WorkerRequest[] = [];
  const commits: { id: string; objects?: number; accept(): void; refuse(): void }[] = [];
  const store = {
    restarts: 0,
    send: (request: WorkerRequest) => {
      requests.push(request);
      if (request.kind !== 'commit') return Promise.resolve();
      return new Promise<void>((accept, reject) => {
        commits.push({ ...request.info, accept, refuse: () => reject(new Error('No room.')) });
      });
    },
    delete: (id: string) => store.send({ kind: 'delete', id }),
  };
  const editor = {
    document,
    commands: document.commands,
    fileChanged: new Signal(),
    file: { name: null, handle: null, seen: null },
    drafts: { problem: 'refused', fail: () => {}, work: () => {} },
    notices: { show: () => 1, remove: () => {} },
  };
  const autosave = new Autosave(editor as unknown as EditorApi, store as unknown as AutosaveStore, Promise.resolve());
  const add = (): void => document.commands.run(addObject(document.scene, new GameObject('Box'), document.scene, []));
  return { autosave, document, requests, commits, add };
}

it('what changes during a commit is stored by another once that is answered, and nothing after it', async () => {
  const { autosave, commits, add } = open();
  add();
  await settle();
  add();
  await settle();
  expect([commits.length, autosave.isUpToDate]).toEqual([1, false]);
  commits[0].accept();
  await settle();
  expect(commits.map(({ objects }) => objects)).toEqual([1, 2]);
  commits[1].accept();
  await settle();
  expect([commits.length, autosave.isUpToDate, autosave.statistics.commits]).toEqual([2, true, 2]);
});

it('a refused commit is tried again, with what changed during it', async () => {
  const { autosave, commits, add } = open();
  add();
  await settle();
  add();
  commits[0].refuse();
  await settle();
  expect(commits.map(({ objects }) => objects)).toEqual([1, 2]);
  commits[1].accept();
  await settle();
  expect([commits.length, autosave.isUpToDate]).toEqual([2, true]);
});

it('a commit that is answered after another scene was opened leaves no draft of the old one', async () => {
  const { autosave, document, requests, commits, add } = open();
  add();
  await settle();
  document.opened.emit();
  await settle();
  commits[0].accept();
  await settle();
  expect(requests.filter(({ kind }) => kind === 'delete')).toEqual([{ kind: 'delete', id: commits[0].id }]);
  expect([commits.length, autosave.isUpToDate]).toEqual([1, true]);
});

it('is up to date where a scene that nobody has edited changes by itself, and reads that with the first edit', async () => {
  const { autosave, document, requests, commits, add } = open();
  await settle();
  document.scene.add(new GameObject('Spark'));
  await settle();
  expect([commits.length, autosave.isUpToDate]).toEqual([0, true]);
  add();
  await settle();
  expect([commits.map(({ objects }) => objects), autosave.isUpToDate]).toEqual([[2], false]);
  commits[0].accept();
  await settle();
  expect(autosave.isUpToDate).toBe(true);
  const parts = requests.flatMap((request) => (request.kind === 'parts' ? request.parts : []));
  expect(parts.some(([, json]) => json?.includes('Spark'))).toBe(true);
});
