export { registerSceneAssets } from '@farol/engine/scenes';
