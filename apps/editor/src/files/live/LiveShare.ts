import { Signal, t, tCount } from '@farol/editing';
import { createId, type FileAsset } from '@farol/engine/files';
import type { EditorApi } from '../../api/EditorApi';
import { HEAD, type PartChange, type PartKey } from '../autosave/parts';
import { SceneDelta } from '../autosave/SceneDelta';
import {
  assetKey,
  changesBetween,
  liveAsset,
  type LiveMessage,
  liveSocket,
  type RelayMessage,
  SCRIPTS,
  splitHead,
} from './liveParts';

/** Shortest time between two messages while a gesture is open (ms). */
const PREVIEW = 50;

/** Longest time in a frame for reading parts of the scene (ms). */
const SLICE = 4;

/** Approximate size of a message when the whole scene is sent (characters). */
const CHUNK = 500_000;

/** Delay before a lost connection is tried again (ms). */
const RETRY = 2000;

/** Key in sessionStorage of this tab's secret; with it the address that phones have open survives a reload. */
const KEY = 'farol-phone-key';

const isHead = (key: PartKey): boolean => key.startsWith('h/') || key.startsWith('a/');

/**
 * Shows the scene, and each edit, on pages of other devices, through the dev server. Nothing is read or sent while no
 * page is connected.
 */
export class LiveShare {
  /** Emits when the addresses or the number of viewing pages change. */
  readonly changed = new Signal();
  /** URLs that show the scene, one for each network of this machine; null until known, empty without `--host`. */
  addresses: readonly string[] | null = null;

  private socket: WebSocket | null = null;
  private id = '';
  private count = 0;
  private delta: SceneDelta | null = null;
  /** JSON of each part of the scene as last sent to the viewing pages. */
  private readonly sent = new Map<PartKey, string>();
  /** Numbers of viewing pages that wait for the whole scene; null stands for all of them. */
  private waiting = new Set<number | null>();
  private readonly hashes = new WeakMap<Blob, string>();
  private readonly uploaded = new Set<string>();
  private isDue = false;
  private lastRead = 0;
  private sending: Promise<unknown> = Promise.resolve();
  private hasBegun = false;
  private readonly ends: (() => void)[];

  constructor(private readonly editor: EditorApi) {
    const { document } = editor;
    const noteAssets = (): void => this.note((delta) => delta.noteAssets());
    this.ends = [
      document.sceneChanged.subscribe((change) => this.note((delta) => delta.note(change))),
      document.assetsChanged.subscribe(noteAssets),
      document.scripts.changed.subscribe(noteAssets),
      document.opened.subscribe(() => this.delta && this.begin(null)),
      document.simulation.changed.subscribe(() => this.tellPlay()),
    ];
    void this.connect();
  }

  /** Number of viewing pages. */
  get looks(): number {
    return this.count;
  }

  /** Ends the connection for good. */
  end(): void {
    for (const end of this.ends.splice(0)) end();
    const { socket } = this;
    this.socket = null;
    socket?.close();
    this.setLooks(0, '');
  }

  private async connect(): Promise<void> {
    if (this.ends.length === 0) return;
    const pages = await phonePages();
    this.addresses = pages.length > 0 ? null : pages;
    this.changed.emit();
    if (pages.length === 0 || this.ends.length === 0) return;
    const key = sessionStorage.getItem(KEY) ?? createId() + createId() + createId();
    sessionStorage.setItem(KEY, key);
    const socket = (this.socket = liveSocket(`edit=${key}`));
    socket.addEventListener('message', ({ data }) => {
      const message = JSON.parse(String(data)) as RelayMessage;
      if (message.kind === 'problem') this.editor.log.add('warning', 'file', message.problem);
      else if (message.kind === 'join') this.begin(message.number);
      else if (message.kind === 'hello') {
        this.id = message.id;
        this.uploaded.clear();
        this.addresses = pages.map((page) => `${page}&look=${message.id}`);
        this.setLooks(message.looks);
      } else if (message.kind === 'looks') this.setLooks(message.looks);
    });
    socket.addEventListener('close', ({ code }) => {
      if (socket !== this.socket) return;
      this.rest();
      this.setLooks(0);
      // another page uses the tab's secret, as a duplicate of the tab does
      if (code === 4000) sessionStorage.removeItem(KEY);
      setTimeout(() => void this.connect(), RETRY);
    });
  }

  private setLooks(looks: number, text = looksText(looks)): void {
    this.count = looks;
    if (looks === 0) this.rest();
    const { phones } = this.editor;
    // emits only when the text changes: sharing may end while React renders the dialog and forbids other updates
    if (phones.text !== text) {
      phones.text = text;
      phones.changed.emit();
    }
    this.changed.emit();
  }

  /** Forgets which parts were read and sent, once no page is connected. */
  private rest(): void {
    this.delta = null;
    this.sent.clear();
    this.waiting.clear();
  }

  /** Schedules a transfer of the whole scene. @param number - page that waits for it; null for all, in a new scene */
  private begin(number: number | null): void {
    this.waiting.add(number);
    if (!this.delta || number === null) {
      this.delta = new SceneDelta(this.editor.document.scene);
      this.delta.noteAll();
      this.sent.clear();
    }
    this.schedule();
  }

  private note(note: (delta: SceneDelta) => void): void {
    if (!this.delta) return;
    note(this.delta);
    this.schedule();
  }

  /** Tells viewing pages to restart the scene when it begins to play; not when it continues after a pause. */
  private tellPlay(): void {
    const { state } = this.editor.document.simulation;
    if (state === 'playing' && !this.hasBegun && this.count > 0) this.post({ kind: 'play' });
    this.hasBegun = state !== 'stopped';
  }

  private schedule(): void {
    if (this.isDue) return;
    this.isDue = true;
    // a hidden page gets no animation frames
    if (document.hidden) setTimeout(() => this.frame(), PREVIEW);
    else requestAnimationFrame(() => this.frame());
  }

  private frame(): void {
    this.isDue = false;
    const { delta, editor } = this;
    if (!delta) return;
    const start = performance.now();
    if (editor.commands.isGestureOpen && start - this.lastRead < PREVIEW) return this.schedule();
    this.lastRead = start;
    const parts = delta.read(() => performance.now() - start > SLICE);
    const isWhole = delta.isEmpty;
    this.sending = this.sending
      .then(() => this.send(delta, parts, isWhole))
      .catch((error: Error) => editor.log.add('warning', 'file', error.message));
    if (!isWhole) this.schedule();
  }

  /** Sends changed parts. @param isWhole - whether no part is left to be read */
  private async send(delta: SceneDelta, read: readonly PartChange[], isWhole: boolean): Promise<void> {
    const head = read.find(([key]) => key === HEAD)?.[1];
    const hashes = head ? await this.upload((JSON.parse(head) as { assets: FileAsset[] }).assets) : null;
    if (delta !== this.delta) return;
    const changes = read.filter(([key]) => key !== HEAD);
    if (head && hashes) {
      const before = new Map([...this.sent].filter(([key]) => isHead(key)));
      changes.unshift(
        ...changesBetween(
          before,
          splitHead(head, ({ name }) => hashes.get(assetKey(name))),
        ),
      );
      changes.push([SCRIPTS, String(this.editor.document.scripts.isOn)]);
    }
    const parts = changes.filter(([key, json]) => (this.sent.get(key) ?? null) !== json);
    for (const [key, json] of parts) {
      if (json === null) this.sent.delete(key);
      else this.sent.set(key, json);
    }
    const isForAll = this.waiting.has(null);
    if (parts.length > 0 && !isForAll) this.post({ kind: 'parts', parts });
    if (!isWhole) return;
    for (const number of isForAll ? [null] : this.waiting) this.postWhole(number ?? undefined);
    this.waiting.clear();
  }

  private postWhole(to?: number): void {
    this.post({ kind: 'whole', to });
    let parts: PartChange[] = [];
    let letters = 0;
    for (const part of this.sent) {
      parts.push(part);
      letters += part[1].length;
      if (letters < CHUNK) continue;
      this.post({ kind: 'parts', to, parts });
      parts = [];
      letters = 0;
    }
    this.post({ kind: 'parts', to, parts });
    this.post({ kind: 'end', to });
  }

  private post(message: LiveMessage): void {
    if (this.socket?.readyState === WebSocket.OPEN) this.socket.send(JSON.stringify(message));
  }

  /** Sends the bytes of assets that the server does not have. @returns their hashes, by the key of the asset */
  private async upload(assets: readonly FileAsset[]): Promise<Map<PartKey, string>> {
    const found = new Map<PartKey, string>();
    for (const { name, file } of assets) {
      const blob = file === undefined ? null : this.editor.document.assets.fileOf(name);
      if (!blob) continue;
      const hash = this.hashes.get(blob) ?? (await sha256(blob));
      this.hashes.set(blob, hash);
      found.set(assetKey(name), hash);
      if (this.uploaded.has(hash)) continue;
      const headers = { 'x-farol-key': sessionStorage.getItem(KEY) ?? '' };
      const { ok, status } = await fetch(liveAsset(this.id, hash), { method: 'PUT', body: blob, headers });
      if (!ok) {
        throw new Error(t('{name} is too large for the page on the phone ({status}).', { name, status }));
      }
      this.uploaded.add(hash);
    }
    return found;
  }
}

/** Number of viewing pages, as text. */
export const looksText = (looks: number): string =>
  looks === 0 ? t('nobody looks') : tCount(looks, '{count} looks', '{count} look');

async function sha256(blob: Blob): Promise<string> {
  const bytes = new Uint8Array(await crypto.subtle.digest('SHA-256', await blob.arrayBuffer()));
  return Array.from(bytes, (byte) => byte.toString(16).padStart(2, '0')).join('');
}

/** Addresses of the viewing page, from the dev server; none in a built editor, or without `--host`. */
async function phonePages(): Promise<readonly string[]> {
  try {
    const { phone } = (await (await fetch('./apps.json')).json()) as { phone?: readonly string[] };
    return phone ?? [];
  } catch {
    return [];
  }
}

const shares = new WeakMap<EditorApi, LiveShare>();

/** The LiveShare of an editor; a new one if the dev server lacked `--host`, since it may have been restarted. */
export function shareOf(editor: EditorApi): LiveShare {
  const before = shares.get(editor);
  if (before && before.addresses?.length !== 0) return before;
  before?.end();
  const share = new LiveShare(editor);
  shares.set(editor, share);
  return share;
}

export function endShare(editor: EditorApi): void {
  shares.get(editor)?.end();
  shares.delete(editor);
}
