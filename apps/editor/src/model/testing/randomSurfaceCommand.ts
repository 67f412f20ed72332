import { type Command, SetFields } from '@farol/editing';
import { AssetLibrary, ModelRenderer, ObjectRenderer } from '@farol/engine';
import type { FieldOwner } from '@farol/engine/fields';
import { renameAsset } from '../assetEdits';
import { deleteAsset } from '../assetUsages';
import type { EditorDocument } from '../EditorDocument';
import { resetFields } from '../edits';
import { addSurface, ownSurfaceValues, type SurfaceWearer, wearSurface } from '../surfaceEdits';
import { below, pick, type Random } from './random';
import { randomEdit } from './randomEdit';
import { randomValue } from './randomValue';

/** Texts of surfaces: with different uniforms, and broken ones. */
const texts: readonly string[] = [
  'uniform float height; // = 0.2 [0, 1]\n// reach: height\nvoid displace(inout VertexData v) { v.positionOS.y += height; }',
  'uniform float height; // = 0.4\nuniform vec3 tintColor; // = #ff8800\nvoid surface(inout SurfaceData s) { s.color *= tintColor; }',
  'uniform vec2 way; // = 1, 0\nuniform bool isOn; // = true\nuniform sampler2D pattern;\nvoid surface(inout SurfaceData s) {}',
  'uniform mat4 broken;\nvoid surface(inout SurfaceData s) {}',
  'no surface',
];

/** Waits for the renderer's code for surfaces; without it surfaces have no uniforms. */
export function loadSurfaces(): Promise<void> {
  const assets = new AssetLibrary();
  return new Promise((resolve) => {
    assets.onChange(({ kind }) => kind === 'loaded' && resolve());
    assets.addFieldAsset('surface', 'any', { source: texts[0] });
  });
}

/** A random edit of the surfaces: adds, edits, uses, renames or removes one. */
export function randomSurfaceCommand(random: Random, document: EditorDocument): Command {
  const { assets, scene } = document;
  const surfaces = assets.fieldAssets('surface');
  const wearers: SurfaceWearer[] = [...scene.componentsOf(ObjectRenderer), ...scene.componentsOf(ModelRenderer)];
  const some = wearers.filter(() => random() < 0.4);
  // texts typed while the scene plays survive stopping
  const act = document.simulation.state === 'stopped' ? below(random, 12) : 5 + below(random, 7);
  if (act === 0 || (act < 4 && surfaces.length < 3))
    return addSurface(scene, `Surface ${below(random, 20)}`, pick(random, texts), {}, random() < 0.5 ? some : [])
      .command;
  if (surfaces.length === 0) return randomEdit(random, document, scene.settings);
  const surface = pick(random, surfaces);
  if (act === 1) return deleteAsset(scene, surface.name);
  if (act === 2) {
    const name = `${random() < 0.3 ? 'Looks/' : ''}Worn ${below(random, 1000)}`;
    return renameAsset(scene, surface.name, assets.has(name) ? surface.name : name);
  }
  if (act === 3) {
    const value = `${pick(random, texts)} // ${below(random, 1000)}`;
    return new SetFields('Edit surface', [{ owner: surface, name: 'source', value }]);
  }
  const material = assets.materialAssets.find((each) => each.get('surface') !== null);
  const owners: FieldOwner[] = [...wearers, ...(material ? [material] : [])].filter(uniformsOf);
  if (act < 6 || owners.length === 0) return wearSurface(surface.name, some);
  if (act === 6) {
    const edits = some.map((owner) => ({ owner, name: 'surface', value: null }));
    return new SetFields('Take off', edits);
  }
  if (act === 7 && material) {
    const users = some.filter((each) => each instanceof ObjectRenderer);
    return ownSurfaceValues(users, material);
  }
  const owner = pick(random, owners);
  const name = pick(random, uniformsOf(owner)!);
  if (random() < 0.2) return resetFields('Reset', [owner], [name]);
  const value = randomValue(random, owner.fields[name], document);
  return new SetFields('Set uniform', [{ owner, name, value }]);
}

/** Fields of an owner that are uniforms of its surface; null when it has none. */
function uniformsOf({ fields }: FieldOwner): string[] | null {
  const names = Object.keys(fields).filter((name) => fields[name].viewOf !== undefined);
  return names.length > 0 ? names : null;
}
