import { type Command, type EditRecorder, type FieldTarget, type Gesture, SetFields, Signal } from '@farol/editing';
import type { FieldValue } from '@farol/editing/fields';
import { type ClipAsset, type ClipData, ClipPreview, type Component, type GameObject } from '@farol/engine';
import type { EditorDocument } from '../EditorDocument';
import { clipDataOf, noteClipData, writeClip } from './clipDataOf';
import { durationOf, frameRateOf, setClip } from './clipEdits';
import { playedClip, playedTime, playerAbove, playerOfClip } from './clipPlayer';
import { EMPTY_CLIP, findTrack, roundTime } from './clipTracks';
import { type ClipSelection, ClipSelections } from './ClipSelections';
import type { KeyEdit, KeySelection } from './editKeys';
import { componentOf, recordEdit } from './recordEdit';
import { addressOf } from './trackTargets';

/** Serialised data of a clip; '' for no clip. */
const textOf = (clip: ClipAsset | null): string => (clip ? (clip.getAuthored('data') as string) : '');

/**
 * The clip being edited, its object and the playhead. While previewing, the object shows the clip at the playhead;
 * while recording, edits of fields become keys there.
 */
export class Timeline implements EditRecorder {
  /** Emits when the clip is replaced or edited, and when selection, recording or playback changes. */
  readonly changed = new Signal();
  /** Emits when the playhead moves. */
  readonly moved = new Signal();

  private currentClip: ClipAsset | null = null;
  private currentRoot: GameObject | null = null;
  /** Name of the clip that the user chose in place of the one that the object plays; null for none. */
  private chosen: string | null = null;
  private seconds = 0;
  private readonly selections = new ClipSelections();
  private preview: ClipPreview | null = null;
  private isOpen = false;
  private previews = false;
  private records = false;
  private plays = false;
  private isWaiting = false;
  private endings: (() => void)[] = [];

  /** @param redraw - called when the viewport must be redrawn */
  constructor(
    readonly document: EditorDocument,
    private readonly redraw: () => void,
  ) {}

  /** The edited clip; null for none. */
  get clip(): ClipAsset | null {
    return this.currentClip;
  }

  /** The object that the clip animates; null when there is none. */
  get root(): GameObject | null {
    return this.currentRoot;
  }

  get data(): ClipData {
    return this.currentClip ? clipDataOf(this.currentClip) : EMPTY_CLIP;
  }

  get duration(): number {
    return this.currentClip ? durationOf(this.currentClip) : 1;
  }

  /** Frames per second of the edited clip. */
  get frameRate(): number {
    return this.currentClip ? frameRateOf(this.currentClip) : 30;
  }

  /** Time of the playhead (s). */
  get time(): number {
    return this.seconds;
  }

  get selection(): ClipSelection {
    return this.selections.current;
  }

  get isRecording(): boolean {
    return this.records;
  }

  /** Whether the clip plays while the scene is stopped. */
  get isPlaying(): boolean {
    return this.plays;
  }

  /** Whether the object shows the clip at the playhead instead of its authored values. */
  get isPreviewing(): boolean {
    return this.previews;
  }

  /** Whether the scene plays or is paused, so that the playhead follows it. */
  get isFollowing(): boolean {
    return this.document.simulation.state !== 'stopped';
  }

  /** Whether there is a clip and an object, so that edits can become keys. */
  get canRecord(): boolean {
    return this.canPreview;
  }

  private get canPreview(): boolean {
    return this.isOpen && !this.isFollowing && this.currentClip !== null && this.currentRoot !== null;
  }

  /** Called when the timeline panel is shown: subscribes to the document. */
  open(): void {
    if (this.isOpen) return;
    this.isOpen = true;
    const { document } = this;
    const refresh = (): void => this.refresh();
    this.endings = [
      document.selection.changed.subscribe(refresh),
      document.assetSelection.changed.subscribe(refresh),
      document.assetsChanged.subscribe(refresh),
      document.structure.subscribe(refresh),
      document.opened.subscribe(() => this.forget()),
      document.edited.subscribe(() => this.edited()),
      document.simulation.changed.subscribe(() => this.simulationChanged()),
    ];
    this.refresh();
  }

  /** Called when the panel is hidden: the scene shows its authored values again. */
  close(): void {
    if (!this.isOpen) return;
    this.endPreview();
    this.isOpen = false;
    for (const end of this.endings) end();
    this.endings = [];
  }

  /** Selects the clip to edit. @param name - null for the clip that the object plays */
  choose(name: string | null): void {
    this.chosen = name;
    this.refresh();
  }

  /** Moves the playhead to a time (s), and shows the object at that time. */
  setTime(seconds: number): void {
    const time = Math.max(seconds, 0);
    if (this.isFollowing) return;
    const isMoved = time !== this.seconds;
    this.seconds = time;
    if (this.canPreview) this.startPreview();
    if (isMoved) this.moved.emit();
  }

  /** Rounds a time (s) to the nearest frame. */
  readonly snap = (time: number): number => roundTime(Math.round(time * this.frameRate) / this.frameRate);

  /** Moves the playhead by a number of frames, which may be negative. */
  stepFrames(count: number): void {
    this.setTime(roundTime((Math.round(this.seconds * this.frameRate) + count) / this.frameRate));
  }

  setRecording(records: boolean): void {
    if (records === this.records || (records && !this.canPreview)) return;
    this.records = records;
    if (records) this.startPreview();
    this.shownChanged();
    this.changed.emit();
  }

  play(): void {
    if (!this.canPreview || this.plays) return;
    this.plays = true;
    this.startPreview();
    this.changed.emit();
  }

  pause(): void {
    if (!this.plays) return;
    this.plays = false;
    this.changed.emit();
  }

  /** Called each frame while the clip or the scene plays. */
  advance(deltaSeconds: number): void {
    if (this.isFollowing) {
      const { currentRoot: root, currentClip: clip } = this;
      const time = root && clip && playedTime(root, clip.name);
      if (time === null || time === this.seconds) return;
      this.seconds = time;
      this.moved.emit();
    } else if (this.plays) {
      const { duration } = this;
      const next = this.seconds + deltaSeconds;
      this.setTime(duration > 0 ? next % duration : 0);
    }
  }

  /** Shows the authored values again; the playhead stays. */
  endPreview(): void {
    const wasOn = this.previews || this.records || this.plays;
    this.previews = false;
    this.records = false;
    this.plays = false;
    if (this.document.commands.recorder === this) this.document.commands.recorder = null;
    this.preview?.end();
    this.preview = null;
    if (!wasOn) return;
    this.shownChanged();
    this.changed.emit();
  }

  select(keys: KeySelection, events: readonly number[] = []): void {
    this.selections.select({ keys, events });
    this.changed.emit();
  }

  /** Edits the clip, as one undo step. */
  edit(label: string, edit: KeyEdit | ClipData, events: readonly number[] = []): void {
    const { clip } = this;
    if (!clip) return;
    const { data, selected } = 'selected' in edit ? edit : { data: edit, selected: this.selection.keys };
    this.expect(data, { keys: selected, events });
    this.document.commands.run(setClip(label, clip, data));
  }

  /** Begins a drag: any number of previews, each replacing the one before, and one undo step at the end. */
  beginEdit(): ClipGesture | null {
    const { clip } = this;
    if (!clip) return null;
    const { data, duration, selection: before } = this;
    const gesture: Gesture = this.document.commands.begin();
    return {
      data,
      preview: (label, edit, events = []) => {
        if (!gesture.isOpen) return;
        const { data: next, selected } = 'selected' in edit ? edit : { data: edit, selected: before.keys };
        this.expect(next, { keys: selected, events });
        gesture.preview(setClip(label, clip, next, duration));
      },
      previewDuration: (label, seconds) => {
        if (gesture.isOpen) gesture.preview(new SetFields(label, [{ owner: clip, name: 'duration', value: seconds }]));
      },
      commit: () => gesture.commit(),
      discard: () => {
        gesture.discard();
        this.select(before.keys, before.events);
      },
    };
  }

  /** The value that edits of a field start from: while recording, the value at the playhead. */
  valueOf(owner: FieldTarget, name: string): FieldValue | undefined {
    const component = this.records && componentOf(owner);
    if (!component || !this.currentRoot || !addressOf(this.currentRoot, component, name)) return undefined;
    return component.get(name);
  }

  begin(): (command: Command) => Command {
    const { clip, root, data, duration, seconds: time } = this;
    if (!clip || !root) return (command) => command;
    return (command) => {
      // moving objects in the tree reads their poses, which must be the authored ones, not the preview's
      if (!(command instanceof SetFields)) this.interrupt();
      else if (this.records) return recordEdit(command, { clip, root, data, duration, time });
      else if (this.previews && this.isOfTrack(command, root)) this.endPreview();
      return command;
    };
  }

  /** Shows the authored values until the current task ends, so that code that runs now reads them. */
  interrupt(): void {
    this.preview?.end();
    this.preview = null;
    this.edited();
  }

  private isOfTrack(command: Command, root: GameObject): boolean {
    if (!(command instanceof SetFields)) return false;
    return command.edits.some(({ owner, name }) => {
      const component: Component | null = componentOf(owner);
      const address = component && addressOf(root, component, name);
      return address !== null && findTrack(this.data, address) !== undefined;
    });
  }

  /** Called when another scene was opened: forgets the clip, its selection and the time. */
  private forget(): void {
    this.chosen = null;
    this.selections.forget();
    this.currentRoot = null;
    this.currentClip = null;
    this.seconds = 0;
    this.endPreview();
    this.refresh();
  }

  /** Updates the edited clip and its object from the selection. */
  private refresh(): void {
    const { document } = this;
    const asset = document.assetSelection.primary;
    const selected = asset === null ? null : document.assets.fieldAsset(asset);
    const object = document.selectedObjects.at(-1) ?? null;
    let root = this.currentRoot?.scene === document.scene ? this.currentRoot : null;
    let clip: ClipAsset | null = null;
    if (selected?.type === 'clip') {
      clip = selected as ClipAsset;
      root = (object && playerAbove(object)) ?? playerOfClip(document.scene, clip.name);
      this.chosen = root && playedClip(root) === clip.name ? null : clip.name;
    } else {
      if (object) root = playerAbove(object);
      else if (root && !playerAbove(root)) root = null;
      if (root !== this.currentRoot) this.chosen = null;
      const name = this.chosen ?? (root && playedClip(root));
      const found = name === null ? null : document.assets.fieldAsset(name);
      if (found?.type === 'clip') clip = found as ClipAsset;
    }
    if (root === this.currentRoot && clip === this.currentClip) {
      this.changed.emit();
      return;
    }
    this.endPreview();
    this.currentRoot = root;
    this.currentClip = clip;
    this.selections.show(textOf(clip));
    this.changed.emit();
  }

  private startPreview(): void {
    this.previews = true;
    this.document.commands.recorder = this;
    this.showNow();
  }

  private showNow(): void {
    if (!this.previews || !this.currentRoot) return;
    this.preview ??= new ClipPreview(this.currentRoot);
    this.preview.show(this.data, this.seconds);
    this.shownChanged();
  }

  /** Redraws the viewport and, while recording, the inspector, after the preview has changed values of the scene. */
  private shownChanged(): void {
    this.redraw();
    this.document.previewed.emit();
  }

  private edited(): void {
    // once is enough: an edit of many fields emits once per field
    if (this.isWaiting) return;
    this.isWaiting = true;
    queueMicrotask(() => {
      this.isWaiting = false;
      if (!this.isOpen) return;
      this.selections.follow(textOf(this.currentClip), this.data);
      this.changed.emit();
      if (this.previews) this.showNow();
    });
  }

  private simulationChanged(): void {
    if (this.isFollowing) this.endPreview();
    this.changed.emit();
  }

  /** Remembers a selection for these data, before the edit that sets them. */
  private expect(data: ClipData, selection: ClipSelection): void {
    const text = writeClip(data);
    if (this.currentClip && text !== this.selections.text) noteClipData(this.currentClip, text, data);
    this.selections.expect(text, selection);
  }
}

export interface ClipGesture {
  /** Data of the clip when the drag began. */
  readonly data: ClipData;
  /** Shows an edit of `data`, replacing the preview before. */
  preview(label: string, edit: KeyEdit | ClipData, events?: readonly number[]): void;
  previewDuration(label: string, seconds: number): void;
  commit(): void;
  discard(): void;
}
