/** As much of WebGPU as is used here; TypeScript's library does not know it. */
interface Gpu {
  requestAdapter(): Promise<{ readonly info?: Readonly<Record<string, string>> } | null>;
}

let asked: Promise<string | null> | null = null;

/** Name of the adapter that WebGPU draws with; null where there is none. It is asked for once: browsers remark on each. */
export function webgpuName(): Promise<string | null> {
  asked ??= ask((navigator as { gpu?: Gpu }).gpu);
  return asked;
}

async function ask(gpu: Gpu | undefined): Promise<string | null> {
  const adapter = await gpu?.requestAdapter().catch(() => null);
  if (!adapter) return null;
  const { vendor, architecture, device, description } = adapter.info ?? {};
  return [vendor, architecture, device, description].filter((part) => part).join(' ') || 'a WebGPU adapter';
}
