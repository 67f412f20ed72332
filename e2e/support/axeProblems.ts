import AxeBuilder from '@axe-core/playwright';
import { isWhole } from '@farol/tools/extent';
import type { Page } from '@playwright/test';

/**
 * Problems that axe calls serious or critical in the page as it is. @param rules - ids to check; default all
 *
 * Passed rules are not listed, and the result is not handed to a page of its own, which only frames of other origins
 * need: either would take longer than the rules.
 */
export async function axeProblems(page: Page, rules?: readonly string[]): Promise<string[]> {
  const builder = new AxeBuilder({ page }).options({ resultTypes: ['violations'] }).setLegacyMode();
  if (rules) builder.withRules([...rules]);
  const { violations } = await builder.analyze();
  return violations
    .filter(({ impact }) => impact === 'serious' || impact === 'critical')
    .flatMap(({ id, nodes }) => nodes.map(({ html, failureSummary }) => `${id}: ${html}\n${failureSummary}`));
}

/** As `axeProblems` in verify. The slice asks axe where accessibility is the subject, not on the way of other tests. */
export const axeProblemsInVerify = async (page: Page, rules?: readonly string[]): Promise<string[]> =>
  isWhole ? axeProblems(page, rules) : [];
