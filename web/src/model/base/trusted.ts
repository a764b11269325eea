/**
 * Trusted Types, for pages whose policy requires them: script URLs and markup then need a named
 * policy.
 */

interface TrustedTypes {
  createPolicy(name: string, rules: Policy): Policy;
}

interface Policy {
  createScriptURL(url: string): string;
  createHTML(markup: string): string;
}

/** Name that the page's policy has to allow: `trusted-types seamwise`. */
export const policyName = 'seamwise';

let policy: Policy | undefined;

/**
 * The policy; it passes text through in browsers without Trusted Types.
 * @throws {TypeError} where the page allows no policy of this name
 */
function policyOf(): Policy {
  const same = (text: string): string => text;
  const rules: Policy = {createScriptURL: same, createHTML: same};
  const {trustedTypes} = globalThis as {trustedTypes?: TrustedTypes};
  return (policy ??= trustedTypes?.createPolicy(policyName, rules) ?? rules);
}

/**
 * A URL of the project's own script.
 * @throws {TypeError} where the page does not allow the policy
 */
export const trustedScript = (url: string): string => policyOf().createScriptURL(url);

/**
 * Markup that is only parsed and never becomes part of the page.
 * @throws {TypeError} where the page does not allow the policy
 */
export const trustedMarkup = (markup: string): string => policyOf().createHTML(markup);
