import type { EditorApi } from '../api/EditorApi';
import type { Container } from '../model/commands/Placement';
import { shortText, t } from '@farol/editing';
import { type FileMap, isContainer } from '@farol/engine/files';
import type { DraggedAsset } from './dragAsset';
import { importFiles, importOnly, isImportable } from './importFiles';
import { pointInPicture } from './landInPicture';
import { type DropPlace, placeAsset } from './placeAsset';

/**
 * The scene among files: a `.farol`, one that a program renamed to `.zip`, or a `.json` unless there is something to
 * import, since many models come with one.
 */
export async function sceneAmong(files: FileMap): Promise<File | null> {
  const paths = [...files.keys()];
  const isPlain = !paths.some((path) => isImportable(path));
  const path = paths.find((each) => /\.farol$/i.test(each)) ?? paths.find((each) => isPlain && /\.json$/i.test(each));
  if (path !== undefined) return files.get(path)!;
  for (const [each, file] of files) {
    if (/\.zip$/i.test(each) && isContainer(new Uint8Array(await file.arrayBuffer())))
      return new File([file], file.name.replace(/\.zip$/i, '.farol'));
  }
  return null;
}

/** Dropped data: an asset of the editor, or files. */
export interface Dropped {
  readonly asset: DraggedAsset | null;
  readonly files: FileMap;
}

export type DropTarget =
  | {
      readonly kind: 'picture';
      /** Position of the drop on the page (CSS pixels). */ readonly x: number;
      readonly y: number;
    }
  | { readonly kind: 'tree'; /** Id of the object of the row; null beside the rows. */ readonly id: string | null }
  /** Outside viewport and tree: files are imported but not placed. */
  | { readonly kind: 'elsewhere' };

function placeOf(editor: EditorApi, target: DropTarget): DropPlace {
  if (target.kind === 'picture') return { at: target, target: editor.viewport.pick(pointInPicture(editor, target)) };
  const object = target.kind === 'tree' && target.id !== null ? editor.document.scene.findById(target.id) : null;
  const parent: Container | undefined = object ?? undefined;
  return { parent, target: object };
}

/** Imports dropped files and places them, or places a dropped asset. A scene among the files is opened instead. */
export async function dropOn(editor: EditorApi, { asset, files }: Dropped, target: DropTarget): Promise<void> {
  if (asset) {
    if (target.kind !== 'elsewhere') await placeAsset(editor, asset, placeOf(editor, target));
    return;
  }
  const scene = await sceneAmong(files);
  if (scene) {
    const bytes = new Uint8Array(await scene.arrayBuffer());
    if (await editor.openFileBytes(bytes, { name: scene.name, handle: null })) tellLeftOut(editor, scene, files);
    return;
  }
  const place = placeOf(editor, target);
  if (target.kind === 'elsewhere') {
    await importOnly(editor, files);
    return;
  }
  const { names } = await importFiles(editor, files);
  for (const name of names) await placeAsset(editor, { kind: editor.document.assets.typeOf(name)!, name }, place);
}

/** Reports files that came with a scene and were ignored. */
function tellLeftOut(editor: EditorApi, scene: File, files: FileMap): void {
  const ignored = [...files.values()]
    .map(({ name }) => name)
    .filter((name) => name !== scene.name && name.replace(/\.zip$/i, '.farol') !== scene.name)
    .map((name) => shortText(name, 80));
  if (ignored.length === 0) return;
  const names = ignored.slice(0, 4).join(', ') + (ignored.length > 4 ? ', …' : '');
  const text = t('{scene} was opened by itself, without {names}: drop these again.', {
    scene: shortText(scene.name, 80),
    names,
  });
  editor.notices.show('warning', text);
}
