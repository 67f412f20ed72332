import type { WorkerRequest, WorkerResponse } from './messages';
import { assembleParts, type PartChange } from './parts';
import { deleteSession, listSessions, readSession, writeSession } from './store';

/** What was sent since the last commit. It is stored at once, so that what is stored is always a whole scene. */
let waiting: PartChange[] = [];
const files = new Map<string, Blob | null>();
/** Writes are done one after another. */
let last: Promise<unknown> = Promise.resolve();

async function answer(request: WorkerRequest): Promise<unknown> {
  switch (request.kind) {
    case 'parts':
      waiting.push(...request.parts);
      return null;
    case 'file':
      files.set(request.path, request.blob);
      return null;
    case 'drop':
      waiting = [];
      files.clear();
      return null;
    case 'commit': {
      const parts = waiting;
      const blobs = new Map(files);
      waiting = [];
      files.clear();
      await writeSession(request.info, parts, blobs);
      return null;
    }
    case 'list':
      return listSessions();
    case 'read': {
      const stored = await readSession(request.id);
      return { text: JSON.stringify(assembleParts(stored.parts)), files: stored.files };
    }
    case 'delete':
      await deleteSession(request.id);
      return null;
  }
}

addEventListener('message', ({ data }: MessageEvent<{ id: number; request: WorkerRequest }>) => {
  const reply = (response: WorkerResponse): void => postMessage(response);
  last = last
    .then(() => answer(data.request))
    .then(
      (result) => reply({ id: data.id, result }),
      (error: unknown) => reply({ id: data.id, error: error instanceof Error ? error.message : String(error) }),
    );
});
