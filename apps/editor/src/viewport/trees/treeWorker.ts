import { growTree, type TreeSource } from './growTree';

/** The used part of a worker's global scope, whose types conflict with those of the page. */
const scope = globalThis as unknown as {
  addEventListener(type: 'message', listener: (event: MessageEvent<{ id: number; source: TreeSource }>) => void): void;
  postMessage(message: unknown, transfer: Transferable[]): void;
};

scope.addEventListener('message', ({ data: { id, source } }) => {
  try {
    const tree = growTree(source);
    const { roots, indirectBuffer } = tree as unknown as { roots: ArrayBuffer[]; indirectBuffer: Uint32Array };
    scope.postMessage({ id, tree }, [...roots, indirectBuffer.buffer as ArrayBuffer]);
  } catch (error) {
    scope.postMessage({ id, error: String(error) }, []);
  }
});
