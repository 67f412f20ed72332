import type { Page } from '@playwright/test';
import './editor';

/** Work of the editor's page, as much on every machine. */
export interface Work {
  /** Fields of components that are read and written, and signals of components that are looked up. */
  readonly getAuthored: number;
  readonly set: number;
  readonly ownerSignal: number;
  /** Changes of the document that are told. */
  readonly edited: number;
  /** Elements that are made. */
  readonly elements: number;
}

declare global {
  interface Window {
    work: {
      readonly counts: Work;
      /** Counts anew. @param holdsDrafts - whether no draft is read until `release` */
      begin(holdsDrafts: boolean): void;
      /** Lets drafts be read again. */
      release(): void;
    };
  }
}

/**
 * Makes a page count its work.
 *
 * @returns begins to count; the function that it gives ends that. Drafts are held meanwhile unless said otherwise: of them the
 *   page reads more or less, as it is idle
 */
export async function workMeter(page: Page): Promise<(holdsDrafts?: boolean) => Promise<() => Promise<Work>>> {
  await page.evaluate(() => {
    const { document: edited } = window.editor;
    const none: Work = { getAuthored: 0, set: 0, ownerSignal: 0, edited: 0, elements: 0 };
    const counts: Record<keyof Work, number> = { ...none };
    const count = (object: object, method: keyof Work): void => {
      let owner = object as Record<string, (...all: unknown[]) => unknown>;
      while (!Object.hasOwn(owner, method)) owner = Object.getPrototypeOf(owner) as typeof owner;
      const plain = owner[method];
      owner[method] = function (...all) {
        counts[method]++;
        return plain.apply(this, all);
      };
    };
    const { transform } = edited.scene.roots[0];
    count(transform, 'getAuthored');
    count(transform, 'set');
    count(edited, 'ownerSignal');
    edited.edited.subscribe(() => counts.edited++);
    new MutationObserver((changes) => {
      for (const node of changes.flatMap(({ addedNodes }) => [...addedNodes]))
        if (node instanceof Element) counts.elements += 1 + node.querySelectorAll('*').length;
    }).observe(document.body, { subtree: true, childList: true });
    const { requestIdleCallback: whenIdle } = window;
    let held: (() => void)[] | null = null;
    window.requestIdleCallback = (...all) => (held === null ? whenIdle(...all) : held.push(() => whenIdle(...all)));
    window.work = {
      counts,
      begin(holdsDrafts) {
        Object.assign(counts, none);
        if (holdsDrafts) held ??= [];
        else window.work.release();
      },
      release() {
        held?.forEach((read) => read());
        held = null;
      },
    };
  });
  return async (holdsDrafts = true) => {
    await page.evaluate((holds) => window.work.begin(holds), holdsDrafts);
    return () =>
      page.evaluate(() => {
        window.work.release();
        return window.work.counts;
      });
  };
}
