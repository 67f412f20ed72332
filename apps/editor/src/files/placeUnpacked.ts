import { ModelRenderer } from '@farol/engine';
import type { EditorApi } from '../api/EditorApi';
import { unpackModels, whatStaysLinked, whyNotUnpack } from '../model/unpackModels';
import { placeAsset } from './placeAsset';

/** Adds a model to the scene as a tree of objects, in one step. @throws Error when it cannot be unpacked */
export async function placeUnpacked(editor: EditorApi, name: string): Promise<void> {
  const { scene, assets } = editor.document;
  await assets.load(name);
  const problem = whyNotUnpack(assets, name);
  if (problem !== null) throw new Error(problem);
  await placeAsset(editor, { kind: 'model', name }, {}, (object) =>
    unpackModels(scene, [object.getComponent(ModelRenderer)!]),
  );
  const linked = whatStaysLinked(assets, [name]);
  if (linked !== null && editor.document.scene === scene) editor.notices.show('info', linked);
}
