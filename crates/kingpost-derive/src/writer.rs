//! Writes a type to a value of a file.

use proc_macro2::TokenStream as Tokens;
use quote::quote;
use syn::{Data, DataEnum, DataStruct, DeriveInput, Error, Fields, Result};

use crate::naming::{SerdeNames, snake_case};

/// Returns the implementations of `ToValue` and of serde's `Serialize`.
pub fn writer(item: &DeriveInput) -> Result<Tokens> {
    let name = &item.ident;
    let body = match &item.data {
        Data::Struct(data) => of_fields(data)?,
        Data::Enum(data) => of_kinds(data),
        Data::Union(_) => return Err(Error::new_spanned(name, "a struct or an enum")),
    };
    let mut generics = item.generics.clone();
    for parameter in generics.type_params_mut() {
        parameter.bounds.push(syn::parse_quote!(crate::scenario::writing::ToValue));
    }
    let (parameters, arguments, _) = generics.split_for_impl();
    Ok(quote! {
        impl #parameters crate::scenario::writing::ToValue for #name #arguments {
            fn to_value(&self) -> serde_json::Value {
                use crate::scenario::writing;
                #body
            }
        }
        impl #parameters serde::Serialize for #name #arguments {
            fn serialize<Into: serde::Serializer>(&self, serializer: Into) -> Result<Into::Ok, Into::Error> {
                crate::scenario::writing::ToValue::to_value(self).serialize(serializer)
            }
        }
    })
}

fn of_fields(data: &DataStruct) -> Result<Tokens> {
    let mut entries = Vec::new();
    for field in &data.fields {
        let stated = SerdeNames::of(&field.attrs)?;
        let ident = field.ident.as_ref().ok_or_else(|| Error::new_spanned(field, "a field with a name"))?;
        if stated.absent {
            continue;
        }
        let name = stated.in_files(ident);
        let entry = quote!(writing::field(&mut fields, #name, &self.#ident););
        entries.push(match stated.skip_if {
            Some(skip) => quote!(if !#skip(&self.#ident) { #entry }),
            None => entry,
        });
    }
    Ok(quote! {
        let mut fields = serde_json::Map::new();
        #(#entries)*
        serde_json::Value::Object(fields)
    })
}

fn of_kinds(data: &DataEnum) -> Tokens {
    let arms = data.variants.iter().map(|variant| {
        let (ident, kind) = (&variant.ident, snake_case(&variant.ident.to_string()));
        match variant.fields {
            Fields::Unit => quote!(Self::#ident => writing::kind(#kind),),
            _ => quote!(Self::#ident(given) => writing::kind_with_fields(#kind, given),),
        }
    });
    quote!(match self { #(#arms)* })
}
