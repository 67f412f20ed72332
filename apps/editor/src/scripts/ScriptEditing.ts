import { javascriptLanguage, typescriptLanguage } from '@codemirror/lang-javascript';
import { type Gesture, SetFields, Signal, t } from '@farol/editing';
import type { FieldAsset } from '@farol/engine';
import type { EditorDocument } from '../model/EditorDocument';
import { isJavaScript } from '../model/scriptNames';

/** Delay between the last key press and setting the script's text (ms). */
const DELAY = 180;

/** A script that is being typed. */
interface Draft {
  readonly asset: FieldAsset;
  text: string;
  isBroken: boolean;
  /** Text that the script asset has at present. */
  shown: string;
}

const sourceOf = (asset: FieldAsset): string => asset.get('source') as string;

/**
 * Editing of the document's scripts. Once typing pauses, a text without syntax errors is previewed, so that the running
 * scene uses it; one with errors stays a draft while it is being typed. When the user leaves the script, its text
 * becomes one step of history, valid or not, so that no text is lost.
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

  get names(): string[] {
    return this.document.assets
      .fieldAssets('script')
      .map(({ name }) => name)
      .toSorted((a, b) => a.localeCompare(b));
  }

  /** The text of a script, as edited; '' when there is no such script. */
  textOf(name: string): string {
    const asset = this.assetOf(name);
    if (!asset) return '';
    return this.draft?.asset === asset ? this.draft.text : sourceOf(asset);
  }

  /** Texts of all scripts as last edited, by asset name. */
  get texts(): ReadonlyMap<string, string> {
    return new Map(this.names.map((name) => [name, this.textOf(name)]));
  }

  /** Whether the text of a script had syntax errors when it was last set. */
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

  /** Stores typed text, which becomes the script's text once typing pauses. */
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

  /** Makes typed text the script's text at once, if it has no syntax errors. */
  flush(): void {
    clearTimeout(this.timer);
    const { draft } = this;
    if (!draft) return;
    draft.isBroken = hasSyntaxErrors(draft.text, isJavaScript(draft.asset.name));
    if (!draft.isBroken) this.preview(draft);
    this.changed.emit();
  }

  /** Ends editing: commits the typed text as one step of history. */
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

  /** Called when an asset was edited: drops a draft whose text was changed elsewhere. */
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

/** Whether a script has syntax errors. Takes about 1 ms for 500 lines. */
export function hasSyntaxErrors(text: string, isJavaScript: boolean): boolean {
  const { parser } = isJavaScript ? javascriptLanguage : typescriptLanguage;
  let isBroken = false;
  parser.parse(text).iterate({
    enter: ({ type }) => {
      isBroken ||= type.isError;
      return !isBroken;
    },
  });
  return isBroken;
}
