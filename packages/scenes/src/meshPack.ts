import { addMeshPack } from '@farol/engine';

// scene files may name meshes of the demo scenes
addMeshPack(async () => (await import('./registerSceneAssets')).registerSceneAssets);
