// SPDX-License-Identifier: Apache-2.0
// campanelctl recipe: creates a recipe file from another one, or from a kind's defaults, with the options
// applied.
#include "app/cli/commands.h"
#include "app/cli/invocation.h"
#include "app/cli/recipe_options.h"
#include "app/store/database/names.h"
#include "app/store/recipes/recipe_json.h"

using namespace Qt::StringLiterals;

namespace campanel::cli {

Outcome runRecipe(const Invocation& call)
{
    const QStringList words = call.arguments();
    if (words.value(0) == u"new-key")
        return createKey(call);
    if (words.value(0) == u"sign")
        return signFile(call);
    if (words.value(0) == u"verify")
        return verifyFile(call);
    if (words.size() > 1)
        return fail(ExitCode::Usage,
                    u"Unexpected argument \"%1\". See campanelctl recipe --help."_s.arg(words[1]));
    auto recipe = recipeOf(call);
    if (!recipe)
        return tl::unexpected(recipe.error());
    // A new recipe begins with the gentlest ratios.
    if (call.arguments().isEmpty() && !call.isSet(u"k"_s) && !call.isSet(u"ratios"_s))
        recipe = program::gentleRecipe(*recipe);
    if (call.isSet(u"name"_s))
        recipe->name = store::keptName(call.value(u"name"_s)).toStdString();
    if (store::hiddenCharacter(call.value(u"name"_s)))
        return fail(ExitCode::Usage, u"--name has characters that nobody can see. Remove them."_s);
    if (recipe->name.empty() || recipe->name.size() > program::longestNameBytes)
        return fail(ExitCode::Usage,
                    u"--name takes 1 to %1 bytes of UTF-8."_s.arg(program::longestNameBytes));
    return call.deliver(store::toJson(*recipe));
}

} // namespace campanel::cli
