import type { Still } from './holdStill';

const ports = new WeakMap<Worker, MessagePort>();

/** From now on, module workers begin in stillWorker.ts, which holds their clock. */
export async function holdWorkers(): Promise<void> {
  const { default: stillWorker } = await import('./stillWorker?worker&url');
  window.Worker = class extends window.Worker {
    constructor(url: string | URL, options?: WorkerOptions) {
      const { href } = new URL(url, location.href);
      // workers from blob: addresses run no live module
      const isHeld = options?.type === 'module' && !href.startsWith('blob:');
      super(isHeld ? stillWorker : url, isHeld ? { ...options, name: href } : options);
      if (!isHeld) return;
      const { port1, port2 } = new MessageChannel();
      ports.set(this, port1);
      this.postMessage(port2, [port2]);
    }
  };
}

/** Answer of a held worker. */
export async function askWorker<Name extends keyof Still>(
  worker: Worker,
  name: Name,
  values: Parameters<Still[Name]>,
): Promise<Awaited<ReturnType<Still[Name]>>> {
  const port = ports.get(worker);
  if (port === undefined) throw new Error('The module has made its worker before the clock was held.');
  const answer = new Promise<Awaited<ReturnType<Still[Name]>>>((resolve, reject) => {
    const take = ({ data }: MessageEvent) => ('error' in data ? reject(new Error(data.error)) : resolve(data.result));
    port.addEventListener('message', take, { once: true });
    port.start();
  });
  port.postMessage({ name, values });
  return answer;
}
