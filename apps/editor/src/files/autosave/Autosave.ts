import { Signal, t } from '@farol/editing';
import { createId } from '@farol/engine/files';
import type { DraftKeeper, EditorApi } from '../../api/EditorApi';
import { AutosaveStore, lockOf } from './AutosaveStore';
import { noteClean } from './cleanSessions';
import { draftReason } from './draftReason';
import type { RecoveryOffer } from '../../model/Dialogs';
import { SceneDelta } from './SceneDelta';
import { SliceBudget } from './SliceBudget';
import type { SessionInfo } from '../../model/SessionInfo';

/** How long after a change it is read (ms), so that a drag is stored some times a second and not each frame. */
const QUIET = 200;

/** Longest wait for an idle moment (ms). */
const IDLE_WAIT = 100;

/** Waits after writes that were refused, one after another (ms); the last one for as long as it goes on. */
const RETRIES = [1000, 2000, 5000, 10_000, 30_000];

/**
 * Stores what changes in the document, so that a tab that is killed loses at most the last second. The scene is read part
 * by part in idle moments, all of it once it is open, later what changed; a worker stores that from the first change on.
 * A write that is refused is told of, and tried again after a while and with each change.
 */
export class Autosave implements DraftKeeper {
  /** Emits after each time that everything up to now was stored. */
  readonly stored = new Signal();
  /** For measurements: how long each of the last slices took of the page's time (ms), what was read, what was stored. */
  readonly statistics = { slices: [] as number[], parts: 0, commits: 0 };

  private session = createId();
  private delta: SceneDelta;
  private readonly files = new Map<string, Blob>();
  private readonly budget = new SliceBudget();
  private timer = 0;
  /** When the timer ends (ms since the page began). */
  private due = 0;
  private isReading = false;
  /** Commits that are not answered yet. */
  private writes = 0;
  /** When the first change came that is not stored (ms since 1970); null when all is. */
  private changedAt: number | null = null;
  /** When all was last stored; null for never in this session. */
  private storedAt: number | null = null;
  private refusals = 0;
  private restarts = 0;
  /** The message that drafts are not kept. */
  private notice = 0;
  /** A session that this one takes the place of, once it is stored. */
  private replaced: string | null = null;

  /** @param opened - fulfilled when the first scene and the plugins are there: what is recovered comes after them */
  constructor(
    private readonly editor: EditorApi,
    readonly store: AutosaveStore,
    private readonly opened: Promise<unknown>,
  ) {
    const { document, commands } = editor;
    this.delta = new SceneDelta(document.scene);
    this.hold();
    document.opened.subscribe(() => this.restart());
    document.assetsChanged.subscribe(() => this.delta.noteAssets());
    editor.fileChanged.subscribe(() => this.storedAt !== null && this.wake());
    const before = document.onSceneChange;
    document.onSceneChange = (change) => {
      before(change);
      this.delta.note(change);
      this.wakeIfEdited();
    };
    commands.changed.subscribe(() => this.wakeIfEdited());
    // a page that nobody sees may be ended without a word
    window.document.addEventListener('visibilitychange', () => window.document.hidden && this.flush());
    window.addEventListener('pagehide', () => {
      this.flush();
      if (this.storedAt !== null && !commands.isDirty) noteClean(this.session);
    });
    this.delta.noteAll();
    this.readOn();
    this.wakeIfEdited();
  }

  /** Whether everything is stored as it is now. */
  get isUpToDate(): boolean {
    return this.changedAt === null && !this.isReading && this.writes === 0 && this.delta.isEmpty;
  }

  /** What tabs that were killed have left; null when there is nothing. */
  async findLost(): Promise<RecoveryOffer | null> {
    const sessions = (await this.store.lost()).filter(({ isDirty }) => isDirty);
    if (sessions.length === 0) return null;
    return {
      sessions,
      recover: (session) => this.recover(session),
      discard: ({ id }) => this.store.delete(id),
    };
  }

  async offerRecovery(): Promise<boolean> {
    const offer = await this.findLost();
    if (offer) void this.editor.dialogs.show({ kind: 'recover', ...offer });
    return offer !== null;
  }

  /** Something of the store's was refused: it is told of, and what is not stored is tried again. */
  refused(error: unknown): void {
    const { drafts, notices } = this.editor;
    drafts.fail(draftReason(error), this.storedAt ?? this.changedAt ?? Date.now());
    if (this.refusals++ === 0) this.notice = notices.show('error', drafts.problem!, 'file', { lasts: true });
    if (this.store.restarts !== this.restarts) {
      this.restarts = this.store.restarts;
      this.files.clear();
      this.delta.noteAll();
    }
    if (this.changedAt !== null) this.schedule(RETRIES[Math.min(this.refusals, RETRIES.length) - 1]);
  }

  /** Opens a scene that was stored, as one that is not saved: stored again, it takes the place of the old session. @throws Error when another tab has taken it */
  private async recover({ id, name, fileName, handle, seen }: SessionInfo): Promise<void> {
    const { editor } = this;
    await this.opened;
    if (!(await this.store.lost()).some((each) => each.id === id)) {
      throw new Error(t('{name} is not here any more: another tab has recovered or discarded it.', { name }));
    }
    const { text, files } = await this.store.read(id);
    if (!(await editor.openFileBytes(text, { name: fileName, handle, seen }, (path) => files.get(path) ?? null)))
      return;
    editor.commands.markUnsaved();
    this.replaced = id;
    this.wake();
    editor.notices.show('info', t('{name} is as it was. Save it to keep it.', { name }));
  }

  /** Another scene: nothing is stored until it is changed. */
  private restart(): void {
    clearTimeout(this.timer);
    this.timer = 0;
    const old = this.session;
    const wasStored = this.storedAt !== null;
    this.session = createId();
    this.storedAt = null;
    this.changedAt = null;
    this.files.clear();
    this.delta = new SceneDelta(this.editor.document.scene);
    this.hold();
    this.post(this.store.send({ kind: 'drop' }));
    // the user has left it: saved, or thrown away after being asked; what cannot be deleted is offered once more at worst
    if (wasStored) void this.store.delete(old).catch(() => {});
    this.delta.noteAll();
    this.readOn();
  }

  private wakeIfEdited(): void {
    const { commands } = this.editor;
    // what a simulation changes is no edit; once something is stored, it follows whatever comes
    const hasBegun = this.storedAt !== null || this.changedAt !== null || this.writes > 0;
    if (hasBegun || commands.isDirty || commands.isGestureOpen) this.wake();
  }

  /** Something changed that is to be stored. */
  private wake(): void {
    this.changedAt ??= Date.now();
    if (this.writes > 0) return;
    // a write that was refused need not wait for its next turn
    if (!this.timer || this.refusals > 0) this.schedule(this.refusals > 0 ? RETRIES[0] : QUIET);
  }

  private schedule(delay: number): void {
    const due = performance.now() + delay;
    if (this.timer && this.due <= due) return;
    clearTimeout(this.timer);
    this.due = due;
    this.timer = window.setTimeout(() => {
      this.timer = 0;
      this.readOn();
    }, delay);
  }

  /** Reads what is to be read, and stores it then if something changed. */
  private readOn(): void {
    if (this.isReading) return;
    this.isReading = true;
    this.budget.begin();
    this.next();
  }

  private next(): void {
    if (!('requestIdleCallback' in window)) setTimeout(() => this.slice(null), 30);
    else requestIdleCallback((idle) => this.slice(idle), { timeout: IDLE_WAIT });
  }

  /** @param idle - until when the page has nothing else to do; null when it cannot be known */
  private slice(idle: IdleDeadline | null): void {
    if (!this.isReading) return;
    const start = performance.now();
    const left = idle?.didTimeout === false ? idle.timeRemaining() : Infinity;
    const late = this.changedAt === null ? 0 : Date.now() - this.changedAt;
    const budget = this.budget.of(left, late);
    this.read(() => performance.now() - start > budget, this.budget.most());
    if (this.delta.isEmpty) this.finishReading();
    const { slices } = this.statistics;
    slices.push(performance.now() - start);
    if (slices.length > 1000) slices.shift();
    if (this.isReading) this.next();
  }

  private read(isOver: () => boolean, most?: number): void {
    const parts = this.delta.read(isOver, most);
    if (parts.length > 0) this.post(this.store.send({ kind: 'parts', parts }));
    this.statistics.parts += parts.length;
  }

  private finishReading(): void {
    this.isReading = false;
    if (this.changedAt !== null && this.writes === 0) this.commit();
  }

  /** Reads and sends what waits, at once. */
  private flush(): void {
    if (this.changedAt === null) return;
    clearTimeout(this.timer);
    this.timer = 0;
    this.read(() => false);
    this.isReading = false;
    this.commit();
  }

  /** Everything that changed has been sent: it may be stored. */
  private commit(): void {
    this.sendFiles();
    const { replaced, session, editor, changedAt } = this;
    const { document, commands, file } = editor;
    const info: SessionInfo = {
      id: session,
      name: document.scene.name,
      fileName: file.name,
      // what stands in for one cannot be stored
      handle: 'FileSystemFileHandle' in window && file.handle instanceof FileSystemFileHandle ? file.handle : null,
      seen: file.seen,
      time: Date.now(),
      objects: document.scene.size,
      edit: commands.last?.label ?? null,
      isDirty: commands.isDirty || commands.isGestureOpen,
    };
    this.writes++;
    this.changedAt = null;
    this.store.send({ kind: 'commit', info }).then(
      () => this.committed(info, replaced),
      (error: unknown) => {
        this.writes--;
        // another scene has been opened meanwhile: what was refused is not its
        if (session === this.session) this.changedAt = changedAt;
        this.refused(error);
      },
    );
  }

  private async committed(info: SessionInfo, replaced: string | null): Promise<void> {
    if (replaced) {
      await this.store.delete(replaced).catch(() => {});
      if (this.replaced === replaced) this.replaced = null;
    }
    this.writes--;
    this.statistics.commits++;
    if (info.id === this.session) this.storedAt = info.time;
    else void this.store.delete(info.id).catch(() => {});
    if (this.refusals > 0) {
      this.refusals = 0;
      this.editor.drafts.work();
      this.editor.notices.remove(this.notice);
      this.editor.notices.show('info', t('Drafts are kept again.'));
    }
    this.stored.emit();
    // what changed meanwhile
    if (this.changedAt !== null) this.schedule(QUIET);
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

  /** What is not answered is not stored either: the commit that comes after it says so. */
  private post(sent: Promise<unknown>): void {
    sent.catch((error: unknown) => this.refused(error));
  }

  /** Tells other tabs that this session is alive, for as long as the tab is. */
  private hold(): void {
    const held = navigator.locks.request(lockOf(this.session), () => new Promise(() => {}));
    // at worst another tab offers what is open here
    held.catch(() => {});
  }
}
