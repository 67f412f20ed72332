import { SetFields, t } from '@farol/editing';
import type { SurfaceAsset } from '@farol/engine';
import type { FarolRenderer } from '@farol/renderer';
import type { MicroShaderCompileEntry } from '@farol/renderer/authoring';
import { Surface } from '@farol/renderer/surfaces';
import type { ConsoleLog } from '../model/ConsoleLog';
import type { EditorDocument } from '../model/EditorDocument';
import { type MicroShaderProblemText, problemOf, TextDrafts } from './TextDrafts';

/** Prefix of names of surfaces in places that also name microshaders. */
export const SURFACE = 'surface:';

/**
 * Editing of the document's surfaces. A text that compiles is used at once and becomes a step of history; one that does
 * not stays a draft, while the viewport keeps the last valid text.
 */
export class SurfaceEditing extends TextDrafts<SurfaceAsset> {
  constructor(
    private readonly document: EditorDocument,
    private readonly farol: FarolRenderer,
    log: ConsoleLog,
  ) {
    super(() => document.commands, log);
    document.materials.subscribe(() => this.follow());
    document.assetsChanged.subscribe(() => this.follow());
    document.opened.subscribe(() => this.forget());
  }

  get names(): string[] {
    return this.document.assets
      .fieldAssets('surface')
      .map(({ name }) => name)
      .toSorted((a, b) => a.localeCompare(b));
  }

  /** Why the edited text of a surface is not in use; null when it is. */
  problem(name: string): MicroShaderProblemText | null {
    const asset = this.document.assets.surface(name);
    if (!asset) return null;
    return this.problems.get(asset) ?? (asset.problem ? problemOf(asset.problem) : null);
  }

  /** Text of a surface, as last edited, even where it does not compile. */
  textOf(name: string): string {
    const asset = this.document.assets.surface(name);
    return asset ? (this.drafts.get(asset) ?? asset.source) : '';
  }

  /** Notes typed text, which is compiled once typing pauses. */
  edit(name: string, text: string): void {
    const asset = this.document.assets.surface(name);
    if (asset) this.type(asset, text);
  }

  /** Discards a draft that does not compile. */
  discardDraft(name: string): void {
    this.flush();
    const asset = this.document.assets.surface(name);
    if (asset) this.drop(asset);
    this.changed.emit();
  }

  protected override compile(asset: SurfaceAsset, text: string): SetFields | null {
    if (text !== asset.source || asset.problem) this.attempt(asset, text);
    const label = t('Edited surface {name}', { name: asset.name });
    return asset.source === text ? null : new SetFields(label, [{ owner: asset, name: 'source', value: text }]);
  }

  protected override chunkOf({ name }: SurfaceAsset): string {
    return SURFACE + name;
  }

  protected override chunkAt({ name }: SurfaceAsset, { chunk }: MicroShaderCompileEntry): string {
    return chunk === null || chunk === name ? SURFACE + name : chunk;
  }

  /** Compiles a text before the document gets it. @throws MicroShaderCompileError */
  private attempt(asset: SurfaceAsset, text: string): void {
    const { surface } = asset;
    if (!surface) return new Surface(asset.name, text).compile(this.farol);
    try {
      // compiles the surface even if it is not drawn yet
      surface.compile(this.farol);
    } catch {
      // ignored: the surface's previous text did not compile either
    }
    surface.source = text;
  }

  /** Drops drafts of surfaces that were removed. */
  private follow(): void {
    for (const asset of [...this.drafts.keys(), ...this.problems.keys()])
      if (this.document.assets.surface(asset.name) !== asset) this.drop(asset);
    this.changed.emit();
  }
}

/** The part of an editor that editing surfaces uses. */
interface SurfaceHost {
  readonly document: EditorDocument;
  readonly viewport: { readonly farol: FarolRenderer };
  readonly log: ConsoleLog;
}

const known = new WeakMap<SurfaceHost, SurfaceEditing>();

/** The surface editing of an editor, created at the first call. */
export function surfaceEditingOf(editor: SurfaceHost): SurfaceEditing {
  let editing = known.get(editor);
  if (!editing) {
    const { document, viewport, log } = editor;
    known.set(editor, (editing = new SurfaceEditing(document, viewport.farol, log)));
  }
  return editing;
}
