/** `window.stage` of the Lab's `stage.html` as far as the tests use it: see apps/lab/src/stage/Stage.ts. */
export interface StageHandle {
  open(name: string, labCase: object, options: { signal: AbortSignal; longestFrame: number }): Promise<OpenedHandle>;
  turn(name: string, ms: number): Promise<{ frame: number[]; cpu: number[]; gpu: number[] | null }>;
  count(name: string): Promise<Record<'draws' | 'triangles' | 'programs' | 'targetBytes' | 'uploadBytes', number>>;
  passes(name: string): Promise<{ kind: string; passes: { name: string; ms: number }[] } | null>;
  addLights(name: string): Promise<{ ms: number; programs: number }>;
  changeTechnique(name: string): Promise<{ ms: number; programs: number } | null>;
  close(name: string): void;
  unavailable(name: string): Promise<string | null>;
  setOwnScene(file: Uint8Array): Promise<void>;
  device(): Promise<{ renderer: string; timer: boolean; software: boolean; webgpu: string | null }>;
}

export interface OpenedHandle {
  firstMs: number;
  dropped: number;
  technique: string | null;
  picture: ImageData;
}

declare global {
  interface Window {
    stage?: StageHandle;
  }
}
