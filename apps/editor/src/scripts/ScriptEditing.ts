import { type Gesture, SetFields, Signal, t } from '@farol/editing';
import type { FieldAsset } from '@farol/engine';
import type { EditorDocument } from '../model/EditorDocument';
import { isJavaScript } from '../model/scriptNames';
import { hasSyntaxErrors } from './hasSyntaxErrors';

/** How long after the last key a text is taken over (ms). */
const DELAY = 180;

/** A text that is being typed. */
interface Draft {
  readonly asset: FieldAsset;
  text: string;
  isBroken: boolean;
  /** The text that the asset has got. */
  shown: string;
}

const sourceOf = (asset: FieldAsset): string => asset.get('source') as string;

/**
 * The scripts of the document as texts that are edited. A text that can be read is taken over once no more keys follow,
 * as a preview, so that the running scene has it; one that cannot stays a draft as long as it is being typed. What was
 * typed until the user turns elsewhere is one step of history, whatever it is: no text is lost.
 */
export class ScriptEditing {
  /** Emits when a text or a draft changes. */
  readonly changed = new Signal();

  private draft: Draft | null = null;
  private readonly checked = new WeakMap<FieldAsset, { readonly source: string; readonly isBroken: boolean }>();
  private timer: ReturnType<typeof setTimeout> | undefined;
  private gesture: Gesture | null = null;

  constructor(private readonly document: EditorDocument) {
    document.materials.subscribe(() => this.edited());
    document.assetsChanged.subscribe(() => this.edited());
    document.opened.subscribe(() => this.forget());
  }

  /** Names of all scripts. */
  get names(): string[] {
    return this.document.assets
      .fieldAssets('script')
      .map(({ name }) => name)
      .toSorted((a, b) => a.localeCompare(b));
  }

  /** The text of a script as it is being edited; '' where there is none of that name. */
  textOf(name: string): string {
    const asset = this.assetOf(name);
    if (!asset) return '';
    return this.draft?.asset === asset ? this.draft.text : sourceOf(asset);
  }

  /** All texts as they are being edited, by name. */
  get texts(): ReadonlyMap<string, string> {
    return new Map(this.names.map((name) => [name, this.textOf(name)]));
  }

  /** Whether the text of a script cannot be read, as it was when it was last taken over or left. */
  isBroken(name: string): boolean {
    const asset = this.assetOf(name);
    if (!asset) return false;
    if (this.draft?.asset === asset) return this.draft.isBroken;
    const source = sourceOf(asset);
    const known = this.checked.get(asset);
    if (known?.source === source) return known.isBroken;
    const isBroken = hasSyntaxErrors(source, isJavaScript(name));
    this.checked.set(asset, { source, isBroken });
    return isBroken;
  }

  /** A key was pressed: takes the text over once no more follow. */
  edit(name: string, text: string): void {
    const asset = this.assetOf(name);
    if (!asset) return;
    if (this.draft && this.draft.asset !== asset) this.finish();
    if (this.draft) this.draft.text = text;
    else this.draft = { asset, text, isBroken: false, shown: sourceOf(asset) };
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.flush(), DELAY);
    this.changed.emit();
  }

  /** Takes over what is typed, where it can be read. */
  flush(): void {
    clearTimeout(this.timer);
    const { draft } = this;
    if (!draft) return;
    draft.isBroken = hasSyntaxErrors(draft.text, isJavaScript(draft.asset.name));
    if (!draft.isBroken) this.preview(draft);
    this.changed.emit();
  }

  /** The user turned elsewhere: what was typed is one step of history. */
  finish(): void {
    clearTimeout(this.timer);
    const { draft } = this;
    this.draft = null;
    if (draft && this.assetOf(draft.asset.name) === draft.asset) this.preview(draft);
    this.gesture?.commit();
    this.gesture = null;
    if (draft) this.changed.emit();
  }

  private assetOf(name: string): FieldAsset | null {
    const asset = this.document.assets.fieldAsset(name);
    return asset?.type === 'script' ? asset : null;
  }

  private preview(draft: Draft): void {
    const { asset, text } = draft;
    if (draft.shown === text) return;
    draft.shown = text;
    if (!this.gesture?.isOpen) this.gesture = this.document.commands.begin();
    const label = t('Edited script {name}', { name: asset.name });
    this.gesture.preview(new SetFields(label, [{ owner: asset, name: 'source', value: text }]));
  }

  /** Something of the library was edited: a draft of a text that got another one elsewhere is out of date. */
  private edited(): void {
    const { draft } = this;
    if (draft && (this.assetOf(draft.asset.name) !== draft.asset || sourceOf(draft.asset) !== draft.shown))
      this.forget();
    this.changed.emit();
  }

  private forget(): void {
    clearTimeout(this.timer);
    this.draft = null;
    this.gesture = null;
  }
}
