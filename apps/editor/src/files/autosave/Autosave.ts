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

/** Delay between a change and reading it (ms): a drag is stored a few times per second, not each frame. */
const QUIET = 200;

/** Longest wait for an idle period (ms). */
const IDLE_WAIT = 100;

/** Delays before retrying refused writes (ms); the last one repeats. */
const RETRIES = [1000, 2000, 5000, 10_000, 30_000];

/**
 * Stores changes of the document as they happen, so that a killed tab loses at most the last second. The scene is read
 * piecewise in idle periods: all of it after opening, then what changed; a worker stores the pieces from the first
 * change on. Refused writes are reported, and retried after a while and with each change.
 */
export class Autosave implements DraftKeeper {
  /** Emits each time everything has been stored. */
  readonly stored = new Signal();
  /** Measurements: durations of the last slices (ms), numbers of parts read and of commits. */
  readonly statistics = { slices: [] as number[], parts: 0, commits: 0 };

  private session = createId();
  private delta: SceneDelta;
  private readonly files = new Map<string, Blob>();
  private readonly budget = new SliceBudget();
  private timer = 0;
  /** Time at which the timer ends (ms since the page began). */
  private due = 0;
  private isReading = false;
  /** Number of commits without an answer yet. */
  private writes = 0;
  /** Time of the first change that is not stored (ms since 1970); null when everything is. */
  private changedAt: number | null = null;
  /** Time when everything was last stored; null for never in this session. */
  private storedAt: number | null = null;
  private refusals = 0;
  private restarts = 0;
  /** Id of the notice that drafts cannot be stored; 0 when it was not shown. */
  private notice = 0;
  /** Id of the recovered session that this one replaces, once stored. */
  private replaced: string | null = null;

  /** @param opened - fulfilled when the first scene and the plugins are loaded; recovery waits for it */
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
    document.sceneChanged.subscribe((change) => {
      this.delta.note(change);
      this.wakeIfEdited();
    });
    commands.changed.subscribe(() => this.wakeIfEdited());
    // a hidden page may be ended without further events
    window.document.addEventListener('visibilitychange', () => window.document.hidden && this.flush());
    window.addEventListener('pagehide', () => {
      this.flush();
      if (this.storedAt !== null && !commands.isDirty) noteClean(this.session);
    });
    this.delta.noteAll();
    this.readOn();
    this.wakeIfEdited();
  }

  /** Whether all edits are stored. Changes before the first edit, as by a simulation, are stored with it. */
  get isUpToDate(): boolean {
    const isRead = this.delta.isEmpty || this.storedAt === null;
    return this.changedAt === null && !this.isReading && this.writes === 0 && isRead;
  }

  /** Unsaved sessions of tabs that were killed; null when there are none. */
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

  /** Reports that the store refused a write, and retries it. */
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

  /**
   * Opens a stored scene as unsaved; once stored again, it replaces the old session. @throws Error when another tab has
   * opened it
   */
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
    editor.notices.show('info', t('{name} is recovered. Save it to keep it.', { name }));
  }

  /** Starts a new session for another scene, which is stored once it is changed. */
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
    // the user saved or discarded the old scene; if deleting it fails, it is merely offered for recovery again
    if (wasStored) void this.store.delete(old).catch(() => {});
    this.delta.noteAll();
    this.readOn();
  }

  private wakeIfEdited(): void {
    const { commands } = this.editor;
    // changes by a simulation alone are not stored; once an edit of the scene is stored, they are, too
    const hasBegun = this.storedAt !== null || this.changedAt !== null || this.writes > 0;
    if (hasBegun || commands.isDirty || commands.isGestureOpen) this.wake();
  }

  /** Notes that the scene has changed, and schedules storing it. */
  private wake(): void {
    this.changedAt ??= Date.now();
    if (this.writes > 0) return;
    // after refused writes, a change shortens a longer wait for the retry to the first delay
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

  /** Continues reading, then stores if something changed. */
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

  /** Reads parts within a time slice. @param idle - the idle period; null when its length is unknown */
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

  /** Reads and stores everything at once. */
  private flush(): void {
    if (this.changedAt === null) return;
    clearTimeout(this.timer);
    this.timer = 0;
    this.read(() => false);
    this.isReading = false;
    this.commit();
  }

  /** Sends a commit, once all changes have been read and sent. */
  private commit(): void {
    this.sendFiles();
    const { replaced, session, editor, changedAt } = this;
    const { document, commands, file } = editor;
    const info: SessionInfo = {
      id: session,
      name: document.scene.name,
      fileName: file.name,
      // a test's stand-in for a handle cannot be stored
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
        // when another scene has been opened meanwhile, `changedAt` belongs to that
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
      this.editor.notices.show('info', t('Drafts are stored again.'));
    }
    this.stored.emit();
    // the scene changed while it was being stored
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

  /** Reports failures of a request; nothing else depends on its answer, since the next commit fails as well. */
  private post(sent: Promise<unknown>): void {
    sent.catch((error: unknown) => this.refused(error));
  }

  /** Holds a lock that tells other tabs that this session is in use. */
  private hold(): void {
    const held = navigator.locks.request(lockOf(this.session), () => new Promise(() => {}));
    // without the lock, another tab may offer this session for recovery
    held.catch(() => {});
  }
}
