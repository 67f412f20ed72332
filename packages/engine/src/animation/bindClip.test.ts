import { AnimationClip, BoxGeometry, Mesh, NumberKeyframeTrack, Object3D, VectorKeyframeTrack } from 'three';
import { describe, expect, test } from 'vitest';
import { Model } from '../assets/Model';
import { GameObject } from '../core/GameObject';
import { bindModelClip, type ChannelSource } from './bindClip';
import type { Channel } from './Channel';
import type { ModelInScene } from './modelsBelow';

/** A mesh with one morph target. */
function face(): Mesh {
  const geometry = new BoxGeometry();
  geometry.morphAttributes.position = [geometry.attributes.position.clone()];
  const mesh = new Mesh(geometry);
  mesh.name = 'Face';
  return mesh;
}

const node = face();
const [clip] = new Model(new Object3D().add(node), [
  new AnimationClip('Smile', -1, [
    new NumberKeyframeTrack('Face.morphTargetInfluences', [0, 1], [0, 1]),
    new VectorKeyframeTrack('Face.position', [0, 1], [0, 0, 0, 1, 2, 3]),
  ]),
]).clips;

/** Binds a clip's tracks; returns channels and problems. @param names - names of the objects below the root */
function bind(names: readonly string[], drawn: Partial<ModelInScene>) {
  const root = new GameObject('Root');
  for (const name of names) root.add(new GameObject(name));
  const channels: ChannelSource = {
    fieldChannel: ({ gameObject }, field) => `object ${gameObject.name} ${field}` as unknown as Channel,
    nodeChannel: ({ name }, property) => `node ${name} ${property}` as unknown as Channel,
  };
  const { bindings, problems } = bindModelClip(clip, root, [drawn as ModelInScene], channels);
  return { channels: bindings.map(({ channel }) => channel), problems };
}

describe('a clip of a model', () => {
  test('drawn whole moves the nodes of the copy', () => {
    const copy = face();
    const drawn = { drawnModel: clip.model, partsRoot: null, three: copy, copyOf: () => copy };
    expect(bind(['Face'], drawn)).toEqual({
      channels: ['node Face morphTargetInfluences', 'node Face position'],
      problems: [],
    });
  });

  test('drawn by parts moves the object that stands for their root, and the morph targets of its copy', () => {
    const copy = face();
    const drawn = { drawnModel: clip.model, partsRoot: node, three: copy, copyOf: () => copy };
    expect(bind(['Face'], drawn)).toEqual({
      channels: ['node Face morphTargetInfluences', 'object Face position'],
      problems: [],
    });
  });

  test('moves the object before a node of its name in another model, but the morph targets of the node', () => {
    const drawn = { drawnModel: new Model(face(), []), partsRoot: null, three: face(), copyOf: () => null };
    expect(bind(['Face'], drawn).channels).toEqual(['node Face morphTargetInfluences', 'object Face position']);
    expect(bind([], drawn).channels).toEqual(['node Face morphTargetInfluences', 'node Face position']);
  });

  test('says where morph targets are missing', () => {
    const plain = new Object3D();
    plain.name = 'Face';
    const drawn = { drawnModel: new Model(plain, []), partsRoot: null, three: plain, copyOf: () => null };
    expect(bind(['Face'], drawn)).toEqual({
      channels: ['object Face position'],
      problems: ["'Root/Face' has no morph targets: show its model by a ModelRenderer."],
    });
  });
});
