import { createId } from '@farol/engine';
import type { Editor } from '../../Editor';
import { Signal } from '../../model/Signal';
import { AutosaveStore, lockOf } from './AutosaveStore';
import { noteClean } from './cleanSessions';
import { SceneDelta } from './SceneDelta';
import type { SessionInfo } from './store';

/** How long after a change it is stored (ms), so that a drag is stored once. */
const QUIET = 800;

/** Time of the page that is used at a stretch (ms); a part that is begun is read to its end. */
const BUDGET = 1;

/** Parts of the first slice: code that has not run before is slow. Each slice may have twice as many as the one before. */
const FIRST = 8;

/**
 * Stores what changes in the document, so that a tab that is killed loses nothing. Only changed parts are read, in idle
 * moments of at most a few milliseconds; a worker stores them.
 */
export class Autosave {
  /** Emits after each time that everything up to now was stored. */
  readonly stored = new Signal();
  /** For measurements: how long each of the last slices took of the page's time (ms), what was read, what was stored. */
  readonly statistics = { slices: [] as number[], parts: 0, commits: 0 };

  private session = createId();
  private delta: SceneDelta;
  private readonly files = new Map<string, Blob>();
  private timer = 0;
  /** Parts that the next slice may read. */
  private most = FIRST;
  private isRunning = false;
  /** Whether something happened while it was running. */
  private again = false;
  /** Whether the whole scene has been noted: from the first change on. */
  private hasBegun = false;
  private failed = false;
  /** A session that this one takes the place of, once it is stored. */
  private replaced: string | null = null;

  constructor(
    private readonly editor: Editor,
    readonly store: AutosaveStore,
  ) {
    const { document, commands } = editor;
    this.delta = new SceneDelta(document.scene);
    this.hold();
    document.opened.subscribe(() => this.restart());
    document.assetsChanged.subscribe(() => this.hasBegun && this.delta.noteAssets());
    editor.fileChanged.subscribe(() => this.hasBegun && this.wake());
    const before = document.onSceneChange;
    document.onSceneChange = (change) => {
      before(change);
      if (this.hasBegun) this.delta.note(change);
      this.wake();
    };
    commands.changed.subscribe(() => this.wake());
    window.addEventListener('pagehide', () => {
      if (this.hasBegun && !commands.isDirty) noteClean(this.session);
    });
  }

  /** Whether everything is stored as it is now. */
  get isUpToDate(): boolean {
    return !this.timer && !this.isRunning && this.delta.isEmpty;
  }

  /** Edits a scene that was recovered: all of it is stored again, and takes the place of the old session then. */
  replace(session: string): void {
    this.replaced = session;
    this.begin();
    this.wake();
  }

  /** Another scene: nothing is stored until it is changed. */
  private restart(): void {
    clearTimeout(this.timer);
    this.timer = 0;
    const old = this.session;
    const isKept = this.hasBegun && !this.failed;
    this.session = createId();
    this.hasBegun = false;
    this.files.clear();
    this.delta = new SceneDelta(this.editor.document.scene);
    this.hold();
    void this.store.send({ kind: 'drop' });
    // the user has left it: saved, or thrown away after being asked; what cannot be deleted is offered once more at worst
    if (isKept) void this.store.delete(old).catch(() => {});
  }

  private begin(): void {
    if (this.hasBegun) return;
    this.hasBegun = true;
    this.delta.noteAll();
  }

  private wake(): void {
    this.again = this.isRunning;
    if (this.failed || this.timer || this.isRunning) return;
    if (!this.hasBegun && !this.editor.commands.isDirty) return;
    this.timer = window.setTimeout(() => {
      this.timer = 0;
      this.begin();
      this.isRunning = true;
      this.next();
    }, QUIET);
  }

  private next(): void {
    if ('requestIdleCallback' in window) requestIdleCallback((deadline) => this.slice(deadline), { timeout: 1000 });
    else setTimeout(() => this.slice(null), 30);
  }

  /** @param deadline - until when the page has nothing else to do; null when it cannot be known */
  private slice(deadline: IdleDeadline | null): void {
    if (!this.hasBegun) {
      this.isRunning = false;
      if (this.again) this.wake();
      return;
    }
    const start = performance.now();
    const budget = Math.min(BUDGET, deadline?.didTimeout === false ? deadline.timeRemaining() : BUDGET);
    const parts = this.delta.read(() => performance.now() - start > budget, this.most);
    this.most *= 2;
    if (parts.length > 0) this.post(this.store.send({ kind: 'parts', parts }));
    const isDone = this.delta.isEmpty;
    if (isDone) this.commit();
    const { statistics } = this;
    statistics.slices.push(performance.now() - start);
    if (statistics.slices.length > 1000) statistics.slices.shift();
    statistics.parts += parts.length;
    if (!isDone) this.next();
  }

  /** Everything that changed has been sent: it may be stored. */
  private commit(): void {
    this.sendFiles();
    const { replaced, session, editor } = this;
    const { document, commands, file } = editor;
    const info: SessionInfo = {
      id: session,
      name: document.scene.name,
      fileName: file.name,
      handle: file.handle,
      time: Date.now(),
      isDirty: commands.isDirty,
    };
    this.post(
      this.store.send({ kind: 'commit', info }).then(async () => {
        this.isRunning = false;
        this.statistics.commits++;
        if (replaced) {
          if (this.replaced === replaced) this.replaced = null;
          await this.store.delete(replaced);
        }
        this.stored.emit();
        // what changed meanwhile
        if (this.again || !this.delta.isEmpty) this.wake();
      }),
    );
  }

  private sendFiles(): void {
    const { files } = this.editor.document.assets;
    const paths = new Map(files.map(({ name, blob }) => [`assets/${encodeURIComponent(name)}`, blob]));
    for (const [path, blob] of paths) {
      if (this.files.get(path) === blob) continue;
      this.files.set(path, blob);
      this.post(this.store.send({ kind: 'file', path, blob }));
    }
    for (const path of this.files.keys()) {
      if (paths.has(path)) continue;
      this.files.delete(path);
      this.post(this.store.send({ kind: 'file', path, blob: null }));
    }
  }

  private post(sent: Promise<unknown>): void {
    sent.catch((error: unknown) => {
      if (this.failed) return;
      this.failed = true;
      const reason = error instanceof Error ? error.message : String(error);
      this.editor.notices.show('error', `Changes are not stored by themselves any more. ${reason} Save by Ctrl+S.`);
    });
  }

  /** Tells other tabs that this session is alive, for as long as the tab is. */
  private hold(): void {
    void navigator.locks.request(lockOf(this.session), () => new Promise(() => {}));
  }
}
