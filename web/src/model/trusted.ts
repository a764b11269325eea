/** For pages whose policy demands Trusted Types: then no text may name a script, or be read as markup, without a name. */

interface TrustedTypes {
  createPolicy(name: string, rules: Policy): Policy;
}

interface Policy {
  createScriptURL(url: string): string;
  createHTML(markup: string): string;
}

/** To be allowed by the page: `trusted-types seamwise`. */
export const policyName = 'seamwise';

let policy: Policy | undefined;

/** As it is where there is no such thing. @throws {TypeError} where the page allows no policy of this name */
function policyOf(): Policy {
  const same = (text: string): string => text;
  const rules: Policy = {createScriptURL: same, createHTML: same};
  const {trustedTypes} = globalThis as {trustedTypes?: TrustedTypes};
  return (policy ??= trustedTypes?.createPolicy(policyName, rules) ?? rules);
}

/** An address of a script of our own. @throws {TypeError} as above */
export const trustedScript = (url: string): string => policyOf().createScriptURL(url);

/** Markup that is only looked at, and never becomes a part of the page. @throws {TypeError} as above */
export const trustedMarkup = (markup: string): string => policyOf().createHTML(markup);
