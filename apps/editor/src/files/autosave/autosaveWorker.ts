import { namedError } from '../browserReason';
import type { WorkerRequest, WorkerResponse } from './messages';
import { assembleParts } from './parts';
import { PendingParts } from './PendingParts';
import { deleteSession, listSessions, readSession, writeSession } from './store';

/** Parts sent since the last commit; stored together, so that the stored scene is always complete. */
const pending = new PendingParts();
/** Ids of sessions that have been stored. */
const stored = new Set<string>();
/** Queue of writes, which run one after another. */
let last: Promise<unknown> = Promise.resolve();

async function answer(request: WorkerRequest): Promise<unknown> {
  switch (request.kind) {
    case 'parts':
      pending.addParts(request.parts);
      return null;
    case 'file':
      pending.addFile(request.path, request.blob);
      return null;
    case 'drop':
      pending.clear();
      return null;
    case 'commit': {
      const { info } = request;
      await pending.store((parts, files) => writeSession(info, parts, files, !stored.has(info.id)));
      stored.add(info.id);
      return null;
    }
    case 'list':
      return listSessions();
    case 'read': {
      const { parts, files } = await readSession(request.id);
      return { text: JSON.stringify(assembleParts(parts)), files };
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
      (error: unknown) => reply({ id: data.id, error: namedError(error) }),
    );
});
