import { addMeshPack } from '@farol/engine';

// scene files may name the meshes of these scenes
addMeshPack(async () => (await import('./registerSceneAssets')).registerSceneAssets);
