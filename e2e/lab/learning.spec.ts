import { expect, test } from '../support/test';

test('auto learns by a press of a button, says what, keeps it over a visit, and forgets it @verify', async ({
  page,
}) => {
  test.setTimeout(240_000);
  await page.goto('./');
  const section = page.getByRole('region', { name: 'What auto learnt on this device' });
  await expect(section.getByRole('status')).toHaveText('Nothing yet.');
  const button = section.getByRole('button', { name: 'Let auto learn' });
  await button.click();
  await expect(section.getByRole('progressbar')).toBeVisible();
  await expect(button).toBeVisible({ timeout: 200_000 });
  const verdicts = section.getByRole('listitem');
  await expect(verdicts.first()).toContainText(/from \d+ lights.*(is faster than|are as fast)/);
  const first = await verdicts.first().textContent();
  await page.reload();
  await expect(verdicts.first()).toHaveText(first!);
  await section.getByRole('button', { name: 'Forget all of it' }).click();
  await expect(section.getByRole('status')).toHaveText('Nothing yet.');
});
