import type { GameObject } from '@farol/engine';
import type { Vector3Tuple } from '@farol/engine/fields';
import { Plane, Raycaster, Vector2, Vector3 } from 'three';
import type { EditorApi } from '../api/EditorApi';
import type { Container } from '../model/commands/Placement';
import { hitPoint } from '../viewport/pick';
import type { FileMap } from '@farol/engine/files';
import type { DraggedAsset } from './dragAsset';
import { importFiles } from './importFiles';
import { type DropPlace, placeAsset } from './placeAsset';

const isScene = (name: string): boolean => /\.(farol|json)$/i.test(name);

/** What was dropped: an asset of the editor's, or files. */
export interface Dropped {
  readonly asset: DraggedAsset | null;
  readonly files: FileMap;
}

/** Where it was dropped. */
export type DropTarget =
  | { readonly kind: 'picture'; /** CSS pixels of the page. */ readonly x: number; readonly y: number }
  | { readonly kind: 'tree'; /** Id of the object of the row; null beside the rows. */ readonly id: string | null }
  /** Files are imported, and nothing is placed. */
  | { readonly kind: 'elsewhere' };

const ground = new Plane(new Vector3(0, 1, 0), 0);
const raycaster = new Raycaster();

/** The point and the object under the pointer: on what is seen there, else on the ground, else in the middle. */
function placeInPicture(editor: EditorApi, x: number, y: number): DropPlace {
  const { viewport, document } = editor;
  const { left, top, width, height } = viewport.canvas.getBoundingClientRect();
  const point = new Vector2(((x - left) / width) * 2 - 1, 1 - ((y - top) / height) * 2);
  const hit = hitPoint(document.scene, viewport.camera, point);
  const target: GameObject | null = viewport.pick(point);
  if (hit) return { point: hit.point.toArray() as Vector3Tuple, target };
  raycaster.setFromCamera(point, viewport.camera);
  const onGround = raycaster.ray.intersectPlane(ground, new Vector3());
  const isNear = onGround && onGround.distanceTo(viewport.camera.position) < 1000;
  return isNear ? { point: onGround.toArray() as Vector3Tuple, target } : { target };
}

function placeOf(editor: EditorApi, target: DropTarget): DropPlace {
  if (target.kind === 'picture') return placeInPicture(editor, target.x, target.y);
  const object = target.kind === 'tree' && target.id !== null ? editor.document.scene.findById(target.id) : null;
  const parent: Container | undefined = object ?? undefined;
  return { parent, target: object };
}

/** Imports what was dropped, where it is files, and places it. A scene among files is opened instead. */
export async function dropOn(editor: EditorApi, { asset, files }: Dropped, target: DropTarget): Promise<void> {
  if (asset) {
    if (target.kind !== 'elsewhere') await placeAsset(editor, asset, placeOf(editor, target));
    return;
  }
  const scene = [...files].find(([path]) => isScene(path));
  if (scene) {
    const [, file] = scene;
    await editor.openFileBytes(new Uint8Array(await file.arrayBuffer()), { name: file.name, handle: null });
    return;
  }
  const place = placeOf(editor, target);
  const { names } = await importFiles(editor, files);
  if (target.kind === 'elsewhere') return;
  for (const name of names) await placeAsset(editor, { kind: editor.document.assets.typeOf(name)!, name }, place);
}
