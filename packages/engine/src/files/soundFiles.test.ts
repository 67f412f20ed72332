import { readFileSync } from 'node:fs';
import { expect, test } from 'vitest';
import '../components/index';
import { AssetLibrary } from '../assets/AssetLibrary';
import { AudioSource } from '../components/AudioSource';
import { GameObject } from '../core/GameObject';
import { Scene } from '../core/Scene';
import { containerContent, inlineAssets, writeContainer } from './container';
import { deserialize } from './deserialize';
import { readSceneFile } from './readSceneFile';
import { serialize } from './serialize';

const bytes = readFileSync(new URL('../../../../public/sounds/step.wav', import.meta.url));

async function sceneWithSound(): Promise<Scene> {
  const scene = new Scene();
  scene.assets.registerFile('Steps/step.wav', new Blob([bytes]));
  await scene.assets.load('Steps/step.wav');
  const object = new GameObject('Walker');
  object.addComponent(AudioSource, { sound: 'Steps/step.wav', loop: true, maxDistance: 7 });
  return scene.add(object);
}

const bytesOf = (scene: Scene): Buffer => Buffer.from(scene.assets.sound('Steps/step.wav').bytes);

test('a sound is kept in files and links, its bytes as they are', async () => {
  const scene = await sceneWithSound();
  const content = containerContent(scene);
  const { text, fileOf } = await readSceneFile(await writeContainer(content));
  const fromFile = await deserialize(text, { assets: new AssetLibrary(), fileOf });
  expect(bytesOf(fromFile).equals(bytes)).toBe(true);
  expect(serialize(fromFile)).toEqual(serialize(scene));
  const linked = JSON.stringify(await inlineAssets(content));
  const fromLink = await deserialize(linked, { assets: new AssetLibrary() });
  expect(bytesOf(fromLink).equals(bytes)).toBe(true);
  expect(fromLink.find('Walker')!.getComponent(AudioSource)!.maxDistance).toBe(7);
});

test('sounds are known by their endings, and have a type of their own', () => {
  const { assets } = new Scene();
  for (const ending of ['mp3', 'ogg', 'wav', 'm4a', 'flac', 'MP3'])
    expect(assets.registerFile(`a.${ending}`, new Blob([bytes])).typeOf(`a.${ending}`)).toBe('sound');
  expect(() => assets.registerFile('a.mid', new Blob([bytes]))).toThrow(/\.wav, \.m4a and \.flac/);
  expect(() => assets.sound('box')).toThrow(/is a mesh: a sound is needed/);
});
